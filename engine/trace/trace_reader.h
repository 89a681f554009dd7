#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "engine/trace/bytes.h"
#include "engine/trace/input_file.h"

namespace palpate {

// One tick of a trace with all its parts.
struct TraceStep {
  TraceTick tick;
  double time = 0.0;       // seconds of the scene since the first tick
  TraceSettings settings;  // in force
  std::vector<std::uint64_t> removed;
  std::vector<TraceMove> moves;
  std::vector<TraceContact> contacts;
};

// A body of a trace.
struct TracedBody {
  TraceBody body;
  std::optional<std::uint64_t> first_tick;  // that knows it
  std::optional<std::uint64_t> end_tick;    // from which on it was removed
};

// Reads a trace, which may be anything: whatever is wrong is an error that names the byte. Of a trace that
// was cut off, all ticks that are whole can be read. Opening looks at every tick but not at its contacts.
class TraceReader {
 public:
  // Errors: kFileNotFound, kFileRead, kBadFormat, kUnsupported (another version).
  static Result<std::unique_ptr<TraceReader>> open(const std::string& path);

  const TraceHeader& header() const { return header_; }
  const std::vector<TracedBody>& bodies() const { return bodies_; }
  std::uint64_t ticks() const { return ticks_.size(); }
  std::uint64_t lost() const { return lost_; }
  double duration() const { return ticks_.empty() ? 0.0 : ticks_.back().time; }  // seconds of the scene
  std::optional<double> first_time_step() const { return first_time_step_; }
  bool complete() const { return complete_; }           // otherwise it was cut off
  std::uint64_t whole_bytes() const { return whole_; }  // from its beginning

  // Errors: kInvalidArgument (no such tick), kFileRead, kBadFormat.
  Status read(std::uint64_t tick, TraceStep& step) const;

  // Where a body was in a tick. Errors: as read(); kInvalidArgument if it was not there.
  Result<TracePose> pose_of(std::uint64_t body, std::uint64_t tick) const;

 private:
  struct TickPlace {
    std::uint64_t offset;  // of the tick, behind its block's head
    double time;
  };
  struct MovePlace {
    std::uint64_t tick;
    std::uint64_t offset;
  };
  struct Journey {
    std::vector<MovePlace> moves;  // ascending
  };
  struct SettingsChange {
    std::uint64_t tick;
    TraceSettings settings;
  };

  explicit TraceReader(InputFile file) : file_(std::move(file)) {}

  Error fault(std::uint64_t offset, const std::string& what) const;
  template <class Record>
  Result<Record> record(std::uint64_t offset) const;
  template <class Record>
  Result<Record> checked(std::uint64_t offset) const;
  Status read_head();
  Status index_blocks();
  Status index_block(std::uint32_t kind, std::uint64_t offset, std::uint64_t size);
  Status index_body(std::uint64_t offset, std::uint64_t size);
  Status index_tick(std::uint64_t offset, std::uint64_t size);
  Status index_parts(const TraceTick& tick, std::uint64_t offset);
  Status index_end(std::uint64_t offset, std::uint64_t size);
  Status know(std::uint64_t body, std::uint64_t offset);
  Status require_tick(std::uint64_t tick) const;
  Result<TracePose> last_move(std::size_t body, std::uint64_t tick) const;

  InputFile file_;
  TraceHeader header_;
  std::vector<TracedBody> bodies_;
  std::vector<Journey> journeys_;                              // by body
  std::unordered_map<std::uint64_t, std::size_t> body_by_id_;  // in bodies_
  std::vector<TickPlace> ticks_;
  std::vector<SettingsChange> settings_;  // ascending
  std::optional<double> first_time_step_;
  std::uint64_t last_step_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t whole_ = 0;
  bool complete_ = false;
};

}  // namespace palpate
