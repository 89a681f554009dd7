#pragma once

#include <cstdint>

#include "engine/device/device_info.h"

namespace palpate {

// What the safety limits hold a device to.
struct SafetySettings {
  double max_force = 0.0;    // N
  double max_torque = 0.0;   // N·m
  double force_slew = 0.0;   // N/ms
  double torque_slew = 0.0;  // N·m/ms
  // A hand moves a handle at 1–2 m/s; encoders that lose count or poses that are mixed up are beyond these.
  double max_speed = 5.0;       // m/s
  double max_turn_rate = 60.0;  // rad/s
  double ramp_time = 0.75;      // s from no force to all of it, after start and after a fault
  double watchdog = 0.010;      // s without a new wrench, a new pose or a tick
  double fault_hold = 0.1;      // s without any cause before a fault gives way to the ramp
  std::uint32_t dead_man = 0;   // buttons that must all be held; none: no dead-man switch

  static SafetySettings for_device(const DeviceLimits& limits) {
    // ms from zero to the maximum: faster than a hand can tell, slower than a kick.
    constexpr double kFullScale = 4.0;
    SafetySettings settings;
    settings.max_force = limits.max_force;
    settings.max_torque = limits.max_torque;
    settings.force_slew = limits.max_force / kFullScale;
    settings.torque_slew = limits.max_torque / kFullScale;
    return settings;
  }
};

}  // namespace palpate
