#include "engine/runtime/hosted_servo.h"

#include <algorithm>
#include <utility>

namespace palpate {

void HostedServo::start(ServoTask& task, std::shared_ptr<GuardedDevice> device) {
  device_ = std::move(device);
  ServoHost& host = *device_->servo_host();
  task_ = &task;
  rate_hz_ = host.rate_hz();
  meter_.emplace();
  period_ = std::max<ServoMeter::Nanoseconds>(
      1, static_cast<ServoMeter::Nanoseconds>(static_cast<double>(ServoMeter::kSecond) / rate_hz_));
  due_ = 0;
  host.carry(*this);
}

void HostedServo::stop() {
  if (!running()) return;
  device_->servo_host()->put_down();
  device_.reset();
}

const ServoStatistics& HostedServo::statistics() {
  static const ServoStatistics kNone;
  return meter_ ? meter_->newest().statistics : kNone;
}

// The host's clock need not agree with ours: a tick is due a period after the one before began.
void HostedServo::tick(double dt) noexcept {
  const ServoMeter::Nanoseconds begin = ServoMeter::now();
  if (due_ == 0) {
    meter_->begin(begin, period_, {});
    due_ = begin;
  }
  task_->tick(dt);
  meter_->tick(due_, begin, ServoMeter::now());
  due_ = begin + period_;
}

}  // namespace palpate
