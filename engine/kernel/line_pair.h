#pragma once

#include "engine/math/vector.h"

namespace palpate {

// Where two lines come closest: p + s·u and q + t·v, and their common normal. Valid unless they are parallel.
// The cross form: its parameters do not cancel as the dot form's do when the lines are nearly parallel.
struct LinePair {
  DVec3 normal;  // u × v, not of unit length
  double normal_squared;
  double s;
  double t;

  LinePair(const DVec3& p, const DVec3& u, const DVec3& q, const DVec3& v)
      : normal(glm::cross(u, v)), normal_squared(glm::dot(normal, normal)) {
    const DVec3 between = q - p;
    s = glm::dot(glm::cross(between, v), normal) / normal_squared;
    t = glm::dot(glm::cross(between, u), normal) / normal_squared;
  }

  // The angle between the lines is at least `sine`, which is small.
  bool inclined(const DVec3& u, const DVec3& v, double sine) const {
    return normal_squared > sine * sine * glm::dot(u, u) * glm::dot(v, v);
  }
};

// NaN, which a parameter of parallel lines may be, becomes 0.
inline double clamp_unit(double x) {
  return x > 0.0 ? (x < 1.0 ? x : 1.0) : 0.0;
}

// Where two segments come closest: p + s·u and q + t·v with s and t from 0 to 1. `between` is q − p, `guess`
// where the lines come closest on the first.
struct SegmentPair {
  double s;
  double t;

  SegmentPair(double guess, const DVec3& between, const DVec3& u, const DVec3& v) : s(clamp_unit(guess)) {
    const double uv = glm::dot(u, v);
    t = clamp_unit((s * uv - glm::dot(between, v)) / glm::dot(v, v));
    s = clamp_unit((t * uv + glm::dot(between, u)) / glm::dot(u, u));
  }
};

}  // namespace palpate
