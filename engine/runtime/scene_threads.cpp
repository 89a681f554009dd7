#include "engine/runtime/scene_threads.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <system_error>

#include "engine/base/clock.h"
#include "engine/base/own_thread.h"

namespace palpate {
namespace {

// Where there is nothing to do, a round comes so often, and takes no more than a tenth of the time.
constexpr double kSearchPauseUs = 1'000.0;
constexpr double kLongestSearchPauseUs = 20'000.0;

std::chrono::duration<double, std::micro> pause_after(double round_us) {
  return std::chrono::duration<double, std::micro>(
      std::clamp(9.0 * round_us, kSearchPauseUs, kLongestSearchPauseUs));
}

// Who runs in this process. Never destroyed: a thread may still stop its scene at exit.
struct Running {
  std::mutex mutex;  // taken before any scene's own
  std::set<SceneThreads*> scenes;
  pid_t process = getpid();  // that has their threads
};

Running& running() {
  static auto* const instance = new Running;
  return *instance;
}

}  // namespace

Status SceneThreads::start(const ServoOptions& options, ServoTask& task) {
  const std::lock_guard all(running().mutex);
  own_process();
  const std::lock_guard lock(mutex_);
  if (running().scenes.contains(this)) return Error{ErrorCode::kWrongState, "the scene's servo runs"};
  running().scenes.insert(this);
  options_ = options;
  task_ = &task;
  return all_or_none([this] {
    Status live = scene_.go_live();
    if (!live) return live;
    Status searching = start_search();
    return searching ? start_servo() : searching;
  });
}

// Starts what `begin` starts; should that fail, no thread is left.
template <class Begin>
Status SceneThreads::all_or_none(Begin&& begin) {
  try {
    Status started = begin();
    if (!started) stop_threads();
    return started;
  } catch (...) {
    stop_threads();
    throw;
  }
}

Status SceneThreads::start_search() {
  stop_search_.emplace();
  try {
    search_ = std::thread([this] { search(); });
  } catch (const std::system_error&) {
    return Error{ErrorCode::kLimit, "the system allows no more threads"};
  }
  return Done{};
}

Status SceneThreads::start_servo() {
  std::shared_ptr<GuardedDevice> device = scene_.device();
  was_hosted_ = device && device->servo_host();
  if (!was_hosted_) return servo_.start(*task_, options_);
  hosted_.start(*task_, std::move(device));
  return Done{};
}

void SceneThreads::stop_servo() {
  servo_.stop();
  hosted_.stop();
}

// The device is exchanged by the loop that there is, which only then gives way.
Status SceneThreads::set_device(std::shared_ptr<GuardedDevice> device, const DeviceMapping& mapping) {
  const std::lock_guard all(running().mutex);
  const std::lock_guard lock(mutex_);
  const std::shared_ptr<GuardedDevice> before = scene_.device();
  const bool stays = device == before || !((device && device->servo_host()) || hosted_.running());
  Status given = scene_.set_device(std::move(device), mapping);
  if (!given || stays || !running().scenes.contains(this)) return given;
  stop_servo();
  return all_or_none([this] { return start_servo(); });
}

void SceneThreads::stop() {
  const std::lock_guard all(running().mutex);
  const std::lock_guard lock(mutex_);
  stop_threads();
}

void SceneThreads::stop_threads() {
  if (running().scenes.erase(this) == 0) return;
  stop_servo();
  if (search_.joinable()) {
    stop_search_->raise();
    search_.join();
  }
  scene_.go_still();
}

// What runs in the process that this one was forked off from does not run here.
void SceneThreads::own_process() {
  if (running().process == getpid()) return;
  running().process = getpid();
  running().scenes.clear();
}

void SceneThreads::stop_all() {
  // Elsewhere there are no threads to wait for, and a lock may be held for ever.
  if (running().process != getpid()) return;
  const std::lock_guard all(running().mutex);
  while (!running().scenes.empty()) {
    SceneThreads& scene = **running().scenes.begin();
    const std::lock_guard lock(scene.mutex_);
    scene.stop_threads();
  }
}

ServoState SceneThreads::state() {
  const std::lock_guard lock(mutex_);
  ServoState state{false, 0.0, {}, {}, scene_.counts(), scene_.result_age()};
  state.running = servo_.running() || hosted_.running();
  state.wanted_rate_hz = was_hosted_ ? hosted_.rate_hz() : servo_.options().rate_hz;
  state.grants = was_hosted_ ? ServoGrants{} : servo_.grants();
  state.statistics = was_hosted_ ? hosted_.statistics() : servo_.statistics();
  return state;
}

void SceneThreads::search() {
  begin_own_thread("palpate-search");
  while (!stop_search_->raised()) {
    const Stopwatch watch;
    bool worked = false;
    try {
      worked = scene_.search_globally();
    } catch (const std::exception&) {
      // Out of memory: the pair stays as it is, and flagged, until the next attempt.
    }
    if (!worked) std::this_thread::sleep_for(pause_after(watch.elapsed_us()));
  }
}

}  // namespace palpate
