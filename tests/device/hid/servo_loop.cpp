#include "tests/device/hid/servo_loop.h"

#include <chrono>

namespace palpate::test {

ServoLoop::ServoLoop(GuardedDevice& device, double force)
    : device_(device), thread_([this, force] { run(force); }) {}

ServoLoop::~ServoLoop() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  thread_.join();
}

void ServoLoop::run(double force) {
  constexpr std::chrono::milliseconds kPeriod(1);
  constexpr double kTick = 1e-3;
  auto due = std::chrono::steady_clock::now();
  while (true) {
    std::this_thread::sleep_until(due += kPeriod);
    const DeviceState state = device_.read();
    device_.write({DVec3(0.0, force, 0.0), DVec3(0.0)}, true, kTick);
    const DeviceStatus status = device_.status();
    const std::lock_guard lock(mutex_);
    if (stopped_) break;
    ticks_.push_back({state, status.applied, status.safety});
    ticked_.notify_all();
  }
  device_.let_go();
}

std::vector<ServoLoop::Tick> ServoLoop::ticks() {
  const std::lock_guard lock(mutex_);
  return ticks_;
}

}  // namespace palpate::test
