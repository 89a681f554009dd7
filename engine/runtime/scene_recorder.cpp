#include "engine/runtime/scene_recorder.h"

#include <chrono>
#include <system_error>

#include "engine/base/own_thread.h"
#include "engine/runtime/trace_records.h"

namespace palpate {
namespace {

// Removals between two ticks that a servo keeps in mind while none of its ticks finds room.
constexpr std::size_t kMostRemoved = 4'096;

constexpr std::chrono::milliseconds kDrainEvery{5};

}  // namespace

Result<std::shared_ptr<SceneRecorder>> SceneRecorder::create(const std::string& path,
                                                             const TraceHeader& header, std::size_t bodies) {
  Result<std::unique_ptr<TraceWriter>> writer =
      TraceWriter::create(path, header, 2 + bodies + kMostRemoved + kMostListed.lmds);
  if (!writer) return writer.error();
  try {
    return std::make_shared<SceneRecorder>(std::move(writer.value()), header.settings);
  } catch (const std::system_error&) {
    return Error{ErrorCode::kLimit, "the system allows no more threads"};
  }
}

SceneRecorder::SceneRecorder(std::unique_ptr<TraceWriter> writer, const TraceSettings& settings)
    : writer_(std::move(writer)), settings_(settings) {
  removed_.reserve(kMostRemoved);
  thread_ = std::thread([this] { drain_till_stopped(); });
}

// The first tick tells where every body is.
void SceneRecorder::meet(Scene& scene) noexcept {
  scene.note_removals(&removed_);
  scene.for_each_body([](Body& body) { body.moved = true; });
}

void SceneRecorder::record(Scene& scene, double dt) noexcept {
  const TraceTick tick = begin_tick(scene, dt);
  if (!writer_->has_room(1 + tick.parts())) {
    ++lost_;
    return writer_->lose_tick();
  }
  push_tick(tick, scene, [this](const TraceCell& cell) { writer_->push(cell); });
}

void SceneRecorder::record_whole(Scene& scene, double dt) noexcept {
  push_tick(begin_tick(scene, dt), scene, [this](const TraceCell& cell) {
    while (!writer_->push(cell)) writer_->drain();
  });
}

TraceTick SceneRecorder::begin_tick(Scene& scene, double dt) const {
  TraceTick tick = trace_of(scene.contacts());
  tick.clock = watch_.elapsed_us() * 1e-6;
  tick.time_step = dt;
  tick.lost = lost_;
  tick.tool = scene.tool();
  if (const Body* tool = scene.find(tick.tool)) tick.tool_pose = trace_of(tool->pose());
  tick.settings_count = trace_settings(scene) == settings_ ? 0 : 1;
  tick.removed_count = static_cast<std::uint32_t>(removed_.size());
  scene.for_each_body([&](const Body& body) { tick.pose_count += body.moved && body.id != tick.tool; });
  return tick;
}

template <class Push>
void SceneRecorder::push_tick(const TraceTick& tick, Scene& scene, Push&& push) {
  push(tick);
  settings_ = trace_settings(scene);
  if (tick.settings_count == 1) push(settings_);
  for (const BodyId id : removed_) push(TraceRemoval{id});
  scene.for_each_body([&](Body& body) {
    if (body.moved && body.id != tick.tool) push(TraceMove{body.id, trace_of(body.pose())});
    body.moved = false;
  });
  for (const Contact& contact : scene.contacts().lmds) push(trace_of(contact));
  removed_.clear();
  lost_ = 0;
}

Recording SceneRecorder::state() {
  return {!stopped_.raised(), writer_->counts()};
}

Status SceneRecorder::finish() {
  stop_thread();
  return writer_->finish();
}

void SceneRecorder::drain_till_stopped() {
  begin_own_thread("palpate-trace");
  while (!stopped_.raised()) {
    writer_->drain();
    woken_.wait(kDrainEvery);
  }
}

void SceneRecorder::stop_thread() {
  if (!thread_.joinable()) return;
  stopped_.raise();
  woken_.ring();
  thread_.join();
}

}  // namespace palpate
