#include "engine/trace/trace_writer.h"

#include <algorithm>
#include <exception>

#include "engine/trace/layout.h"

namespace palpate {
namespace {

// About half a second of a thousand ticks a second with sixty contacts each.
constexpr std::size_t kLeastCells = 32'768;

// A write of the file is at least so long, but for the last.
constexpr std::size_t kFlushBytes = 1u << 18;

}  // namespace

Result<std::unique_ptr<TraceWriter>> TraceWriter::create(const std::string& path, const TraceHeader& header,
                                                         std::size_t largest_tick) {
  Result<OutputFile> file = OutputFile::create(path);
  if (!file) return file.error();
  auto writer =
      std::make_unique<TraceWriter>(std::move(file.value()), std::max(kLeastCells, 4 * largest_tick));
  append_record(TracePrologue{}, writer->buffer_);
  append_record(header, writer->buffer_);
  return writer;
}

Status TraceWriter::begin() {
  const std::lock_guard lock(mutex_);
  if (error_) return *error_;
  if (Status begun = file_.begin(buffer_); !begun) return begun;
  begun_ = true;
  bytes_ = buffer_.size();
  buffered_ticks_ = 0;
  buffer_.clear();
  return Done{};
}

void TraceWriter::add(const TraceBody& body) noexcept {
  const std::lock_guard lock(mutex_);
  attempt([&] {
    TraceBytes bytes;
    append_record(body, bytes);
    const std::string name = body.name.substr(0, kLongestTraceName);
    ByteAppender append(bytes);
    append(static_cast<std::uint32_t>(name.size()));
    for (const char letter : name) append(static_cast<std::uint8_t>(letter));
    append_block(static_cast<std::uint32_t>(TraceBlock::kBody), bytes);
  });
}

void TraceWriter::drain() noexcept {
  const std::lock_guard lock(mutex_);
  TraceCell cell;
  while (ring_.pop(cell)) {
    if (error_ && std::holds_alternative<TraceTick>(cell)) ++dropped_;
    attempt([&] { append(cell); });
  }
  attempt([&] { flush_if(kFlushBytes); });
}

TraceCounts TraceWriter::counts() {
  const std::lock_guard lock(mutex_);
  return count();
}

Status TraceWriter::finish() {
  drain();
  const std::lock_guard lock(mutex_);
  attempt([&] {
    TraceBytes bytes;
    append_record(TraceEnd{ticks_, count().lost}, bytes);
    append_block(static_cast<std::uint32_t>(TraceBlock::kEnd), bytes);
    flush_if(0);
  });
  finished_ = true;
  keep(file_.close());
  if (error_) return *error_;
  return Done{};
}

void TraceWriter::append(const TraceCell& cell) {
  std::visit([&](const auto& record) { append_record(record, tick_); }, cell);
  if (const auto* tick = std::get_if<TraceTick>(&cell)) {
    parts_due_ = tick->parts();
    within_tick_ = true;
  } else if (within_tick_) {
    --parts_due_;
  }
  if (within_tick_ && parts_due_ == 0) end_tick();
}

void TraceWriter::end_tick() {
  append_block(static_cast<std::uint32_t>(TraceBlock::kTick), tick_);
  tick_.clear();
  within_tick_ = false;
  ++ticks_;
  ++buffered_ticks_;
  flush_if(kFlushBytes);
}

void TraceWriter::append_block(std::uint32_t kind, const TraceBytes& bytes) {
  append_record(TraceBlockHead{kind, static_cast<std::uint32_t>(bytes.size())}, buffer_);
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

// Writes what is buffered, if it is so much.
void TraceWriter::flush_if(std::size_t bytes) {
  if (buffer_.size() < bytes || !begun_) return;
  Status written = file_.write(buffer_);
  if (written) {
    bytes_ += buffer_.size();
  } else {
    ticks_ -= buffered_ticks_;
    dropped_ += buffered_ticks_;
  }
  buffered_ticks_ = 0;
  buffer_.clear();
  keep(written);
}

void TraceWriter::keep(const Status& outcome) {
  if (!outcome && !error_) error_ = outcome.error();
}

// Whoever drains is not to fail: what goes wrong is told at the end.
template <class Work>
void TraceWriter::attempt(Work&& work) noexcept {
  if (error_ || finished_) return;
  try {
    work();
  } catch (const std::exception&) {
    error_.emplace(Error{ErrorCode::kOutOfMemory, "out of memory"});
  }
}

}  // namespace palpate
