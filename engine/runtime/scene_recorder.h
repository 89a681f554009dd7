#pragma once

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "engine/base/clock.h"
#include "engine/exchange/bell.h"
#include "engine/exchange/flag.h"
#include "engine/scene/scene.h"
#include "engine/trace/trace_writer.h"

namespace palpate {

// How a recording goes.
struct Recording {
  bool running = false;
  TraceCounts counts;
};

// Puts the ticks of a scene into a trace. A thread beside brings them to the file.
class SceneRecorder {
 public:
  // `bodies`: how many there are about. Errors: as TraceWriter's, and kLimit (no more threads).
  static Result<std::shared_ptr<SceneRecorder>> create(const std::string& path, const TraceHeader& header,
                                                       std::size_t bodies);

  SceneRecorder(std::unique_ptr<TraceWriter> writer, const TraceSettings& settings);
  ~SceneRecorder() { stop_thread(); }
  SceneRecorder(const SceneRecorder&) = delete;
  SceneRecorder& operator=(const SceneRecorder&) = delete;

  // Empties the file and begins it: last of all, because what is in it is lost. Errors: kFileWrite.
  Status begin() { return writer_->begin(); }

  // From any thread, before the scene has the body.
  void add(const TraceBody& body) noexcept { writer_->add(body); }

  // Of the thread that steps the scene: before the first tick, after each, and after the last. A servo's
  // neither allocate, lock nor wait; a tick that finds no room is lost, and counted.
  void meet(Scene& scene) noexcept;
  void leave(Scene& scene) noexcept { scene.note_removals(nullptr); }
  void record(Scene& scene, double dt) noexcept;        // a servo's
  void record_whole(Scene& scene, double dt) noexcept;  // a caller's: none is lost

  Recording state();
  Status finish();  // once; errors as TraceWriter's

 private:
  TraceTick begin_tick(Scene& scene, double dt) const;
  template <class Push>
  void push_tick(const TraceTick& tick, Scene& scene, Push&& push);
  void drain_till_stopped();
  void stop_thread();

  const std::unique_ptr<TraceWriter> writer_;
  const Stopwatch watch_;

  // Of the thread that steps.
  TraceSettings settings_;       // of the last tick that was recorded
  std::vector<BodyId> removed_;  // since
  std::uint64_t lost_ = 0;       // since

  Flag stopped_;
  Bell woken_;
  std::thread thread_;
};

}  // namespace palpate
