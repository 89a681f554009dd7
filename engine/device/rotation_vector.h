#pragma once

#include <cmath>

#include "engine/math/vector.h"

namespace palpate {

// The axis times the angle, at most π, of a unit quaternion.
inline DVec3 rotation_vector(const DQuat& rotation) {
  constexpr double kTiny = 1e-12;  // below, sin(x) and x are the same number
  const double sign = rotation.w < 0.0 ? -1.0 : 1.0;
  const DVec3 axis = sign * DVec3(rotation.x, rotation.y, rotation.z);
  const double sine = glm::length(axis);
  if (sine < kTiny) return 2.0 * axis;
  return axis * (2.0 * std::atan2(sine, sign * rotation.w) / sine);
}

// The rotation that takes `from` to `to`, as a vector in the frame in which both are given.
inline DVec3 rotation_between(const DQuat& from, const DQuat& to) {
  return rotation_vector(to * glm::conjugate(from));
}

// The unit quaternion of a rotation vector.
inline DQuat rotation_by(const DVec3& vector) {
  constexpr double kTiny = 1e-12;
  const double angle = glm::length(vector);
  const double part = angle < kTiny ? 0.5 : std::sin(0.5 * angle) / angle;
  return {std::cos(0.5 * angle), part * vector.x, part * vector.y, part * vector.z};
}

// An orientation after a small turn; the error is of the third order in its angle.
inline DQuat slightly_turned(const DQuat& orientation, const DVec3& turn) {
  return glm::normalize(orientation + DQuat(0.0, 0.5 * turn) * orientation);
}

}  // namespace palpate
