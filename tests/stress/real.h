#pragma once

#include <quadmath.h>

#include <algorithm>

#include "engine/math/vector.h"

namespace palpate::stress {

// 113 bits: products of float32 coordinates and of double poses are exact in it, or as good as.
using Real = __float128;

struct RVec3 {
  Real x, y, z;

  RVec3() : x(0), y(0), z(0) {}
  RVec3(Real first, Real second, Real third) : x(first), y(second), z(third) {}
  template <class T>
  explicit RVec3(const glm::vec<3, T>& v) : x(v.x), y(v.y), z(v.z) {}

  explicit operator DVec3() const {
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
};

inline RVec3 operator+(const RVec3& a, const RVec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline RVec3 operator-(const RVec3& a, const RVec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline RVec3 operator-(const RVec3& a) {
  return {-a.x, -a.y, -a.z};
}
inline RVec3 operator*(const RVec3& a, Real s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline RVec3 operator/(const RVec3& a, Real s) {
  return {a.x / s, a.y / s, a.z / s};
}
inline Real dot(const RVec3& a, const RVec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline RVec3 cross(const RVec3& a, const RVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(const RVec3& a) {
  return sqrtq(dot(a, a));
}
inline RVec3 unit(const RVec3& a) {
  return a / length(a);
}

}  // namespace palpate::stress
