#pragma once

#include "engine/math/vector.h"

namespace palpate {

// A rigid placement: x ↦ rotation · x + translation.
struct Pose {
  DMat3 rotation{1.0};
  DVec3 translation{0.0};
};

inline DVec3 operator*(const Pose& pose, const DVec3& point) {
  return pose.rotation * point + pose.translation;
}

inline Pose inverse(const Pose& pose) {
  const DMat3 back = glm::transpose(pose.rotation);
  return {back, -(back * pose.translation)};
}

inline Pose operator*(const Pose& outer, const Pose& inner) {
  return {outer.rotation * inner.rotation, outer * inner.translation};
}

inline DMat4 matrix_of(const Pose& pose) {
  DMat4 matrix(pose.rotation);
  matrix[3] = DVec4(pose.translation, 1.0);
  return matrix;
}

// The rotation of a quaternion that need not have unit length; its length must be finite and not zero.
inline Pose pose_from(const DVec3& translation, const DQuat& rotation) {
  return {glm::mat3_cast(glm::normalize(rotation)), translation};
}

}  // namespace palpate
