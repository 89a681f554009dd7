#pragma once

#include <mutex>
#include <optional>
#include <thread>

#include "engine/exchange/flag.h"
#include "engine/runtime/live_scene.h"
#include "engine/runtime/servo_thread.h"

namespace palpate {

// The two threads of a live scene. Functions are for any thread.
class SceneThreads {
 public:
  explicit SceneThreads(LiveScene& scene) : scene_(scene) {}
  ~SceneThreads() { stop(); }
  SceneThreads(const SceneThreads&) = delete;
  SceneThreads& operator=(const SceneThreads&) = delete;

  // `task` is what the servo does, the scene's tick() among it; it lives until stop(). Errors: kWrongState
  // (they run), kLimit (no more threads).
  Status start(const ServoOptions& options, ServoTask& task);
  Status start(const ServoOptions& options) { return start(options, scene_); }
  void stop();  // does nothing if they do not run
  ServoState state();

  // Stops the threads of every scene.
  static void stop_all();
  // The same where the process ends, which may be one that was forked off and has none of the threads.
  static void stop_all_of_this_process();

 private:
  void search();
  void stop_threads();

  LiveScene& scene_;
  std::mutex mutex_;  // guards what follows
  ServoThread servo_;
  std::optional<Flag> stop_search_;
  std::thread search_;
};

}  // namespace palpate
