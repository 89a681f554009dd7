#include "engine/trace/trace_reader.h"

#include <algorithm>

#include "engine/trace/layout.h"
#include "engine/trace/trace_check.h"

namespace palpate {
namespace {

// The parts of a tick lie one kind behind the other.
struct PartOffsets {
  std::uint64_t settings, removals, moves, contacts;

  PartOffsets(const TraceTick& tick, std::uint64_t offset)
      : settings(offset + stored_size<TraceTick>()),
        removals(settings + std::uint64_t{tick.settings_count} * stored_size<TraceSettings>()),
        moves(removals + std::uint64_t{tick.removed_count} * stored_size<TraceRemoval>()),
        contacts(moves + std::uint64_t{tick.pose_count} * stored_size<TraceMove>()) {}
};

}  // namespace

Result<std::unique_ptr<TraceReader>> TraceReader::open(const std::string& path) {
  Result<InputFile> file = InputFile::open(path);
  if (!file) return file.error();
  std::unique_ptr<TraceReader> reader(new TraceReader(std::move(file.value())));
  if (Status head = reader->read_head(); !head) return head.error();
  if (Status blocks = reader->index_blocks(); !blocks) return blocks.error();
  return reader;
}

Error TraceReader::fault(std::uint64_t offset, const std::string& what) const {
  return {ErrorCode::kBadFormat, file_.path() + ": byte " + std::to_string(offset) + ": " + what};
}

// The file goes on as far.
template <class Record>
Result<Record> TraceReader::record(std::uint64_t offset) const {
  std::array<std::byte, 512> bytes;
  const std::span used(bytes.data(), stored_size<Record>());
  if (Status read = file_.read(offset, used); !read) return read.error();
  return take_record<Record>(used);
}

template <class Record>
Result<Record> TraceReader::checked(std::uint64_t offset) const {
  Result<Record> found = record<Record>(offset);
  if (!found) return found;
  if (const char* wrong = fault_of(found.value())) return fault(offset, wrong);
  return found;
}

Status TraceReader::read_head() {
  const TracePrologue known;
  const std::uint64_t prologue_size = stored_size<TracePrologue>();
  if (file_.size() < sizeof known.magic) return fault(0, "not a trace");
  if (file_.size() < prologue_size + known.header_size) {
    std::array<std::byte, sizeof known.magic> bytes;
    if (Status read = file_.read(0, bytes); !read) return read;
    std::uint64_t magic;
    ByteTaker{bytes}(magic);
    return fault(magic == known.magic ? file_.size() : 0,
                 magic == known.magic ? "the trace ends within its header" : "not a trace");
  }
  const Result<TracePrologue> prologue = record<TracePrologue>(0);
  if (!prologue) return prologue.error();
  if (prologue.value().magic != known.magic) return fault(0, "not a trace");
  if (prologue.value().version != kTraceVersion)
    return Error{
        ErrorCode::kUnsupported,
        fault(sizeof known.magic, "a trace of version " + std::to_string(prologue.value().version) +
                                      "; this library reads version " + std::to_string(kTraceVersion))
            .message};
  if (!(prologue.value() == known)) return fault(sizeof known.magic, "its records are of other sizes");
  const Result<TraceHeader> header = checked<TraceHeader>(prologue_size);
  if (!header) return header.error();
  header_ = header.value();
  whole_ = prologue_size + known.header_size;
  settings_.push_back({0, header_.settings});
  return Done{};
}

Status TraceReader::index_blocks() {
  constexpr std::uint64_t kHeadSize = 8;
  while (!complete_ && file_.size() - whole_ >= kHeadSize) {
    const Result<TraceBlockHead> head = record<TraceBlockHead>(whole_);
    if (!head) return head.error();
    const std::uint64_t before = whole_;
    if (Status block = index_block(head.value().kind, whole_ + kHeadSize, head.value().size); !block)
      return block;
    if (whole_ == before) return Done{};  // cut off
  }
  if (complete_ && whole_ != file_.size()) return fault(whole_, "the trace goes on behind its end");
  return Done{};
}

// Moves whole_ behind the block, if the file has all of it.
Status TraceReader::index_block(std::uint32_t kind, std::uint64_t offset, std::uint64_t size) {
  const auto index = [&]() -> Status {
    switch (static_cast<TraceBlock>(kind)) {
      case TraceBlock::kBody:
        return index_body(offset, size);
      case TraceBlock::kTick:
        return index_tick(offset, size);
      case TraceBlock::kEnd:
        return index_end(offset, size);
    }
    return fault(offset - stored_size<TraceBlockHead>(), "a block of unknown kind");
  };
  return index();
}

Status TraceReader::index_body(std::uint64_t offset, std::uint64_t size) {
  const std::uint64_t fixed = stored_size<TraceBody>() + sizeof(std::uint32_t);
  if (size < fixed || size > fixed + kLongestTraceName) return fault(offset, "a body is of a wrong size");
  if (size > file_.size() - offset) return Done{};
  const Result<TraceBody> body = checked<TraceBody>(offset);
  if (!body) return body.error();
  TraceBytes rest(size - stored_size<TraceBody>());
  if (Status read = file_.read(offset + stored_size<TraceBody>(), rest); !read) return read;
  std::uint32_t length;
  ByteTaker{rest}(length);
  if (length != size - fixed) return fault(offset, "the name of a body is of a wrong size");
  if (!body_by_id_.emplace(body.value().id, bodies_.size()).second)
    return fault(offset, "a body comes twice");
  TracedBody traced{body.value(), std::nullopt, std::nullopt};
  const auto* letters = reinterpret_cast<const char*>(rest.data());
  traced.body.name.assign(letters + sizeof length, length);
  bodies_.push_back(std::move(traced));
  journeys_.emplace_back();
  whole_ = offset + size;
  return Done{};
}

Status TraceReader::index_tick(std::uint64_t offset, std::uint64_t size) {
  if (size < stored_size<TraceTick>()) return fault(offset, "a tick is of a wrong size");
  if (file_.size() - offset < stored_size<TraceTick>()) return Done{};
  const Result<TraceTick> tick = checked<TraceTick>(offset);
  if (!tick) return tick.error();
  if (size != stored_size(tick.value())) return fault(offset, "a tick is not of the size of its parts");
  if (size > file_.size() - offset) return Done{};
  if (tick.value().step <= last_step_) return fault(offset, "the steps do not ascend");
  const double passed =
      ticks_.empty() ? 0.0 : tick.value().time_step * static_cast<double>(tick.value().step - last_step_);
  ticks_.push_back({offset, ticks_.empty() ? 0.0 : ticks_.back().time + passed});
  if (!first_time_step_) first_time_step_ = tick.value().time_step;
  last_step_ = tick.value().step;
  lost_ += tick.value().lost;
  if (tick.value().tool != 0)
    if (Status known = know(tick.value().tool, offset); !known) return known;
  whole_ = offset + size;
  return index_parts(tick.value(), offset);
}

Status TraceReader::index_parts(const TraceTick& tick, std::uint64_t offset) {
  const PartOffsets parts(tick, offset);
  const std::uint64_t index = ticks_.size() - 1;
  if (tick.settings_count == 1) {
    const Result<TraceSettings> settings = checked<TraceSettings>(parts.settings);
    if (!settings) return settings.error();
    settings_.push_back({index, settings.value()});
  }
  for (std::uint64_t i = 0; i < tick.removed_count; ++i) {
    const std::uint64_t at = parts.removals + i * stored_size<TraceRemoval>();
    const Result<TraceRemoval> removal = record<TraceRemoval>(at);
    if (!removal) return removal.error();
    const auto body = body_by_id_.find(removal.value().body);
    if (body == body_by_id_.end()) return fault(at, "a body is removed that never was");
    if (!bodies_[body->second].end_tick) bodies_[body->second].end_tick = index;
  }
  for (std::uint64_t i = 0; i < tick.pose_count; ++i) {
    const std::uint64_t at = parts.moves + i * stored_size<TraceMove>();
    const Result<TraceMove> move = checked<TraceMove>(at);
    if (!move) return move.error();
    if (Status known = know(move.value().body, at); !known) return known;
    journeys_[body_by_id_.at(move.value().body)].moves.push_back({index, at});
  }
  return Done{};
}

Status TraceReader::index_end(std::uint64_t offset, std::uint64_t size) {
  if (size != stored_size<TraceEnd>()) return fault(offset, "the end is of a wrong size");
  if (size > file_.size() - offset) return Done{};
  const Result<TraceEnd> end = record<TraceEnd>(offset);
  if (!end) return end.error();
  if (end.value().ticks != ticks_.size()) return fault(offset, "the end counts other ticks");
  if (end.value().lost < lost_) return fault(offset, "the end counts fewer lost ticks");
  lost_ = end.value().lost;
  complete_ = true;
  whole_ = offset + size;
  return Done{};
}

// A body of the tick that is indexed.
Status TraceReader::know(std::uint64_t body, std::uint64_t offset) {
  const auto found = body_by_id_.find(body);
  if (found == body_by_id_.end()) return fault(offset, "a tick has a body that is not described before it");
  TracedBody& known = bodies_[found->second];
  if (!known.first_tick) known.first_tick = ticks_.size() - 1;
  return Done{};
}

Status TraceReader::require_tick(std::uint64_t tick) const {
  if (tick < ticks_.size()) return Done{};
  std::string sentence =
      file_.path() + ": has no tick " + std::to_string(tick) + ": there are " + std::to_string(ticks_.size());
  if (!complete_) sentence += ", and it was cut off at byte " + std::to_string(whole_);
  return Error{ErrorCode::kInvalidArgument, std::move(sentence)};
}

Status TraceReader::read(std::uint64_t tick, TraceStep& step) const {
  if (Status there = require_tick(tick); !there) return there;
  const Result<TraceTick> fixed = checked<TraceTick>(ticks_[tick].offset);
  if (!fixed) return fixed.error();
  const std::uint64_t offset = ticks_[tick].offset;
  const std::uint64_t size = stored_size(fixed.value());
  if (size > file_.size() - offset) return fault(offset, "the trace was changed meanwhile");
  TraceBytes bytes(size);
  if (Status read = file_.read(offset, bytes); !read) return read;

  step.tick = fixed.value();
  step.time = ticks_[tick].time;
  const auto later = [](std::uint64_t index, const SettingsChange& change) { return index < change.tick; };
  step.settings = std::prev(std::upper_bound(settings_.begin(), settings_.end(), tick, later))->settings;
  const PartOffsets parts(step.tick, 0);
  const auto part = [&]<class Record>(std::uint64_t first, std::uint64_t i, Record& record) {
    const std::uint64_t at = first + i * stored_size<Record>();
    record = take_record<Record>(std::span(bytes).subspan(at, stored_size<Record>()));
    return at;
  };
  step.removed.clear();
  step.moves.clear();
  step.contacts.clear();
  for (std::uint64_t i = 0; i < step.tick.removed_count; ++i) {
    TraceRemoval removal;
    part(parts.removals, i, removal);
    step.removed.push_back(removal.body);
  }
  for (std::uint64_t i = 0; i < step.tick.pose_count; ++i) {
    TraceMove& move = step.moves.emplace_back();
    const std::uint64_t at = part(parts.moves, i, move);
    if (const char* wrong = fault_of(move)) return fault(offset + at, wrong);
  }
  for (std::uint64_t i = 0; i < step.tick.contact_count; ++i) {
    TraceContact& contact = step.contacts.emplace_back();
    const std::uint64_t at = part(parts.contacts, i, contact);
    if (const char* wrong = fault_of(contact)) return fault(offset + at, wrong);
  }
  return Done{};
}

Result<TracePose> TraceReader::pose_of(std::uint64_t body, std::uint64_t tick) const {
  if (Status there = require_tick(tick); !there) return there.error();
  const auto found = body_by_id_.find(body);
  if (found == body_by_id_.end())
    return Error{ErrorCode::kInvalidArgument, file_.path() + ": has no such body"};
  const TracedBody& traced = bodies_[found->second];
  if (!traced.first_tick || tick < *traced.first_tick || (traced.end_tick && tick >= *traced.end_tick))
    return Error{ErrorCode::kInvalidArgument, file_.path() + ": the body is not there in that tick"};
  const Result<TraceTick> at = checked<TraceTick>(ticks_[tick].offset);
  if (!at) return at.error();
  if (at.value().tool == body) return at.value().tool_pose;
  return last_move(found->second, tick);
}

Result<TracePose> TraceReader::last_move(std::size_t body, std::uint64_t tick) const {
  const std::vector<MovePlace>& moves = journeys_[body].moves;
  const auto later = [](std::uint64_t index, const MovePlace& move) { return index < move.tick; };
  const auto next = std::upper_bound(moves.begin(), moves.end(), tick, later);
  if (next == moves.begin())
    return Error{ErrorCode::kInvalidArgument, file_.path() + ": the body has no pose in that tick"};
  const Result<TraceMove> move = checked<TraceMove>(std::prev(next)->offset);
  if (!move) return move.error();
  return move.value().pose;
}

}  // namespace palpate
