#pragma once

#include <cstdint>
#include <string>

#include "engine/device/device_condition.h"
#include "engine/math/box.h"

namespace palpate {

// A set of degrees of freedom: bits 0 to 2 are translation along x, y, z, bits 3 to 5 rotation about them.
using DegreesOfFreedom = std::uint8_t;
constexpr DegreesOfFreedom kTranslations = 0b000111;
constexpr DegreesOfFreedom kRotations = 0b111000;
constexpr DegreesOfFreedom kAllDegrees = kTranslations | kRotations;

struct DeviceIdentity {
  std::string uri;  // what the registry opens
  std::string name;
  std::string serial;  // empty if the device has none
};

struct DeviceCapabilities {
  DegreesOfFreedom sensed = 0;
  DegreesOfFreedom actuated = 0;
  int buttons = 0;
};

// What a device can do at most. A degree that is not actuated has limits of zero.
struct DeviceLimits {
  double max_force = 0.0;            // N, for short
  double continuous_force = 0.0;     // N, for ever
  double max_torque = 0.0;           // N·m
  double continuous_torque = 0.0;    // N·m
  double max_stiffness = 0.0;        // N/m
  double max_damping = 0.0;          // N·s/m
  double position_resolution = 0.0;  // m, at the tool
  double angle_resolution = 0.0;     // rad
  double update_rate = 0.0;          // Hz
  Box workspace;                     // m, in the base frame
};

struct DeviceInfo {
  DeviceIdentity identity;
  DeviceCapabilities capabilities;
  DeviceLimits limits;
  DeviceCondition condition = DeviceCondition::kReady;  // when it was listed or opened
  std::string advice{};                                 // what its user can do about that; empty: nothing
};

}  // namespace palpate
