#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/device/guarded_device.h"

namespace palpate::test {

// A servo that ticks a device a thousand times a second with a constant wrench, and keeps what it saw.
class ServoLoop {
 public:
  // What a tick began with, and what it ended with.
  struct Tick {
    DeviceState state;
    DeviceWrench applied;
    SafetyReport safety;
  };

  explicit ServoLoop(GuardedDevice& device, double force = 1.0);
  ~ServoLoop();

  // Waits until a tick fulfils it, half a minute at most: a machine may be slow. The number of that tick; -1
  // if there was none.
  template <class Condition>
  long wait_for(Condition&& condition) {
    std::unique_lock lock(mutex_);
    std::size_t at = ticks_.size();
    const bool came = ticked_.wait_for(lock, std::chrono::seconds(30), [&] {
      while (at < ticks_.size() && !condition(ticks_[at])) ++at;
      return at < ticks_.size();
    });
    return came ? static_cast<long>(at) : -1;
  }

  bool wait_until_armed() {
    return wait_for([](const Tick& tick) { return tick.safety.state == SafetyState::kArmed; }) >= 0;
  }

  std::vector<Tick> ticks();

 private:
  void run(double force);

  GuardedDevice& device_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable ticked_;
  std::vector<Tick> ticks_;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace palpate::test
