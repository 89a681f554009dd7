#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "palpate/palpate.h"

namespace palpate::viewer {

using Vec3 = glm::dvec3;
using Quat = glm::dquat;

// x ↦ orientation · x + position.
struct Placement {
  Vec3 position{0.0};
  Quat orientation{1.0, 0.0, 0.0, 0.0};  // w first; unit length

  Vec3 operator*(const Vec3& point) const { return orientation * point + position; }
};

inline Placement operator*(const Placement& outer, const Placement& inner) {
  return {outer * inner.position, outer.orientation * inner.orientation};
}

inline Placement inverse(const Placement& placement) {
  const Quat turned = glm::conjugate(placement.orientation);
  return {turned * -placement.position, turned};
}

inline Vec3 vector_of(const double numbers[3]) {
  return {numbers[0], numbers[1], numbers[2]};
}

inline Placement placement_of(const plp_pose& pose) {
  const double* q = pose.orientation;
  return {vector_of(pose.position), glm::normalize(Quat(q[3], q[0], q[1], q[2]))};
}

inline plp_pose pose_of(const Placement& placement) {
  const Vec3& p = placement.position;
  const Quat& q = placement.orientation;
  return {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}};
}

// For shaders, seen from a point near what is drawn: single precision would not do far from the origin.
inline glm::mat4 matrix_of(const Placement& placement, const Vec3& seen_from) {
  glm::dmat4 matrix = glm::mat4_cast(placement.orientation);
  matrix[3] = glm::dvec4(placement.position - seen_from, 1.0);
  return glm::mat4(matrix);
}

}  // namespace palpate::viewer
