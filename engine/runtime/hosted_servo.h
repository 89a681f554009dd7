#pragma once

#include <memory>
#include <optional>

#include "engine/device/guarded_device.h"
#include "engine/runtime/servo_meter.h"

namespace palpate {

// A task that rides on the loop of a device rather than on a thread of this library, and is timed there. All
// but tick() is for one thread at a time.
class HostedServo : private ServoTask {
 public:
  HostedServo() = default;
  ~HostedServo() { stop(); }
  HostedServo(const HostedServo&) = delete;
  HostedServo& operator=(const HostedServo&) = delete;

  // `task` must live until stop(); the device must have a host, and is kept until then. It must not run
  // already.
  void start(ServoTask& task, std::shared_ptr<GuardedDevice> device);
  void stop();
  bool running() const { return device_ != nullptr; }

  double rate_hz() const { return rate_hz_; }
  const ServoStatistics& statistics();

 private:
  void tick(double dt) noexcept override;

  std::shared_ptr<GuardedDevice> device_;
  ServoTask* task_ = nullptr;
  double rate_hz_ = 0.0;
  std::optional<ServoMeter> meter_;  // of the last time, too

  // The host's thread's.
  ServoMeter::Nanoseconds period_ = 1;
  ServoMeter::Nanoseconds due_ = 0;  // 0: it has not ticked yet
};

}  // namespace palpate
