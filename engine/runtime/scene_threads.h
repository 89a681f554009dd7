#pragma once

#include <mutex>
#include <optional>
#include <thread>

#include "engine/exchange/flag.h"
#include "engine/runtime/hosted_servo.h"
#include "engine/runtime/live_scene.h"
#include "engine/runtime/servo_thread.h"

namespace palpate {

// The two threads of a live scene. Where the scene's device has a loop of its own, that loop is the servo
// thread. Functions are for any thread.
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

  // As LiveScene's. A servo that runs moves to the loop of the device, or back to a thread. Errors: kLimit
  // (no more threads, and none run), too.
  Status set_device(std::shared_ptr<GuardedDevice> device, const DeviceMapping& mapping);

  ServoState state();

  // Stops the threads of every scene; nothing in a process that was forked off, which has none of them.
  static void stop_all();

 private:
  static void own_process();
  void search();
  template <class Begin>
  Status all_or_none(Begin&& begin);
  Status start_search();
  Status start_servo();
  void stop_servo();
  void stop_threads();

  LiveScene& scene_;
  std::mutex mutex_;  // guards what follows
  ServoOptions options_;
  ServoTask* task_ = nullptr;
  ServoThread servo_;
  HostedServo hosted_;
  bool was_hosted_ = false;  // the last time
  std::optional<Flag> stop_search_;
  std::thread search_;
};

}  // namespace palpate
