#pragma once

#include <cmath>

#include "engine/device/device_state.h"
#include "engine/device/device_wrench.h"
#include "engine/math/finite.h"

namespace palpate {

inline bool is_finite(const DeviceWrench& wrench) {
  return is_finite(wrench.force) && is_finite(wrench.torque);
}

// Whether a sample is a motion at all.
inline bool is_finite(const DeviceState& state) {
  constexpr double kUnitSlack = 1e-3;  // a quaternion far from unit length is no orientation
  const RigidMotion& tool = state.tool;
  return is_finite(tool.position) && is_finite(tool.linear_velocity) && is_finite(tool.angular_velocity) &&
         std::isfinite(state.time) && std::abs(glm::length(tool.orientation) - 1.0) < kUnitSlack;
}

}  // namespace palpate
