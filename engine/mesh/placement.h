#pragma once

#include <algorithm>

#include "engine/math/pose.h"
#include "engine/math/triangle.h"
#include "engine/mesh/mesh.h"

namespace palpate {

// Model B seen from model A: x ↦ linear · x + translation takes B's normalised frame to A's. Double
// precision; what is reduced to float32 is reduced after subtraction only.
struct Placement {
  DMat3 rotation;  // of directions
  DMat3 linear;    // rotation times the ratio of the models' scales
  DVec3 translation;
  double ratio;  // B's scale over A's, a power of two

  Placement(const ModelFrame& a, const ModelFrame& b, const Pose& a_from_b)
      : rotation(a_from_b.rotation),
        linear(a_from_b.rotation * (b.scale / a.scale)),
        translation((a_from_b * b.origin - a.origin) / a.scale),
        ratio(b.scale / a.scale) {}

  DVec3 point(const DVec3& b) const { return linear * b + translation; }
  DVec3 into_b(const DVec3& direction) const { return direction * rotation; }  // transposed
};

// Surfaces no farther apart than this (A's normalised frame) touch: five times the rounding of a transformed
// point, whose coordinates are of about 1.
inline double touching_distance(const Placement& placement) {
  constexpr double kTouch = 1e-14;
  return kTouch * std::max(1.0, placement.ratio);
}

// The corners of a triangle of A, and of one of B in A's frame.
inline Triangle triangle_of(const Mesh& mesh, std::uint32_t t) {
  const auto [i, j, k] = mesh.triangles[t];
  return {{mesh.position(i), mesh.position(j), mesh.position(k)}};
}

inline Triangle triangle_of(const Mesh& mesh, std::uint32_t t, const Placement& placement) {
  const auto [i, j, k] = mesh.triangles[t];
  return {{placement.point(mesh.position(i)), placement.point(mesh.position(j)),
           placement.point(mesh.position(k))}};
}

}  // namespace palpate
