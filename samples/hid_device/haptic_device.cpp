#include "samples/hid_device/haptic_device.h"

#include <algorithm>
#include <cmath>

namespace palpate::hid_device {
namespace {

constexpr std::uint8_t kHasDeadMan = 1 << 0;
constexpr std::uint8_t kWantsCalibration = 1 << 1;

constexpr std::uint16_t kOldestAnswered = 64;  // samples: what a host may have queued at most
constexpr double kRamp = 0.1;                  // s in which force fades in

// Shortened to at most `most`.
bool clamp(Vector& v, double most) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (length <= most) return false;
  for (double& part : v) part *= most / length;
  return true;
}

Vector scaled(const Vector& v, double by) {
  return {by * v[0], by * v[1], by * v[2]};
}

}  // namespace

HapticDevice::HapticDevice(const Features& features)
    : features_(features),
      watchdog_(1e-3 * features.watchdog_ms),
      calibrated_(!(features.traits & kWantsCalibration)) {}

// A wrench lives from the time of the sample that it answers: one that was held up is dead when it comes.
bool HapticDevice::take_wrench(Bytes report) {
  const auto order = parse_wrench(report);
  if (!order) return false;
  const auto age = static_cast<std::uint16_t>(sequence_ - order->answered);
  if (age > kOldestAnswered) return false;
  order_ = *order;
  const double life = std::min(1e-3 * order->time_to_live_ms, watchdog_);
  expires_ = time_ - age / double(features_.rate_hz) + life;
  return true;
}

bool HapticDevice::take_command(Bytes report) {
  const auto order = parse_command(report);
  if (!order) return false;
  switch (order->command) {
    case Command::kArm:
      if (!calibrated_ || emergency_ || is_hot()) return false;
      if (!armed_) expires_ = time_ + watchdog_;
      armed_ = true;
      break;
    case Command::kDisarm:
      armed_ = false;
      order_ = {};
      break;
    case Command::kCalibrate:
      if (armed_) return false;
      calibrated_ = true;
      break;
    case Command::kSetWatchdog:
      if (order->milliseconds == 0 || order->milliseconds > features_.watchdog_ms) return false;
      watchdog_ = 1e-3 * order->milliseconds;
      break;
  }
  return true;
}

std::array<std::uint8_t, 64> HapticDevice::step() {
  const double dt = 1.0 / features_.rate_hz;
  time_ += dt;
  ++sequence_;
  if (emergency_ || is_hot()) armed_ = false;
  tripped_ = armed_ && time_ >= expires_;
  push(dt);
  mass_.step(force_, torque_, dt);
  Sample sample;
  sample.flags = flags();
  sample.sequence = sequence_;
  sample.time_us = static_cast<std::uint32_t>(static_cast<std::uint64_t>(std::llround(1e6 * time_)));
  sample.motion = mass_.motion();
  sample.buttons = buttons_;
  sample.temperature = temperature_;
  return report_of(sample);
}

bool HapticDevice::may_push() const {
  return armed_ && !tripped_ && dead_man_;
}

// After anything that made it let go, force fades in anew.
void HapticDevice::push(double dt) {
  ramped_ = may_push() ? std::min(ramped_ + dt, kRamp) : 0.0;
  gain_ = ramped_ / kRamp;
  Vector force = order_.force;
  Vector torque = order_.torque;
  const bool force_cut = clamp(force, features_.max_force);
  const bool torque_cut = clamp(torque, features_.max_torque);
  saturated_ = force_cut || torque_cut;
  force_ = scaled(force, gain_);
  torque_ = scaled(torque, gain_);
}

std::uint8_t HapticDevice::flags() const {
  std::uint8_t flags = 0;
  const auto raise = [&flags](bool raised, Sample::Flag flag) {
    if (raised) flags = static_cast<std::uint8_t>(flags | flag);
  };
  raise(calibrated_, Sample::kCalibrated);
  raise(armed_, Sample::kArmed);
  raise(dead_man_ || !(features_.traits & kHasDeadMan), Sample::kDeadMan);
  raise(tripped_, Sample::kWatchdog);
  raise(is_hot(), Sample::kTooHot);
  raise(saturated_, Sample::kSaturated);
  raise(emergency_, Sample::kEmergency);
  return flags;
}

}  // namespace palpate::hid_device
