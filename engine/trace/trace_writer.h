#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "engine/exchange/counter.h"
#include "engine/exchange/ring.h"
#include "engine/trace/bytes.h"
#include "engine/trace/output_file.h"

namespace palpate {

struct TraceCounts {
  std::uint64_t ticks = 0;  // in the file, or on their way there
  std::uint64_t lost = 0;   // found no room, in memory or in the file
  std::uint64_t bytes = 0;  // of the file
};

// A trace on its way to its file. Ticks go through a ring of fixed size, from one thread at a time that never
// waits to whoever drains it; an error of the file is kept until the end.
class TraceWriter {
 public:
  // A tick of `largest_tick` cells must find room at any time. The file is opened, and nothing else happens
  // to it before begin(). Errors: kFileNotFound, kFileWrite.
  static Result<std::unique_ptr<TraceWriter>> create(const std::string& path, const TraceHeader& header,
                                                     std::size_t largest_tick);

  TraceWriter(OutputFile file, std::size_t cells) : ring_(cells), file_(std::move(file)) {}

  // The producer's, wait-free. A tick comes whole or not at all: it asks for the room of its cells first, or
  // pushes what the ring takes and drains it.
  bool has_room(std::size_t cells) const { return ring_.room() >= cells; }
  bool push(const TraceCell& cell) { return ring_.push(cell); }
  void lose_tick() { lost_.add(1); }

  // Writes how the file begins, in place of what it held. Errors: kFileWrite, kOutOfMemory.
  Status begin();

  // For any thread but a servo: they lock and may allocate, and after an error do nothing but make room.
  void add(const TraceBody& body) noexcept;  // before the first tick that knows it
  void drain() noexcept;
  TraceCounts counts();

  // Drains and ends the file. The first error that there was. Only once; the ring may still be pushed to.
  Status finish();

 private:
  void append(const TraceCell& cell);
  void end_tick();
  void append_block(std::uint32_t kind, const TraceBytes& bytes);
  void flush_if(std::size_t bytes);
  void keep(const Status& outcome);
  TraceCounts count() const { return {ticks_, lost_.value() + dropped_, bytes_}; }
  template <class Work>
  void attempt(Work&& work) noexcept;

  Ring<TraceCell> ring_;
  Counter lost_;

  std::mutex mutex_;  // guards what follows, and that one thread at a time takes from the ring
  OutputFile file_;
  std::optional<Error> error_;
  bool begun_ = false;
  bool finished_ = false;
  TraceBytes tick_;              // the one whose parts are still coming
  std::uint64_t parts_due_ = 0;  // of it
  bool within_tick_ = false;
  TraceBytes buffer_;  // whole blocks
  std::uint64_t ticks_ = 0;
  std::uint64_t buffered_ticks_ = 0;  // of them
  std::uint64_t dropped_ = 0;         // because of the error
  std::uint64_t bytes_ = 0;
};

}  // namespace palpate
