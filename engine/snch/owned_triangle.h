#pragma once

#include "engine/snch/feature_pairs.h"
#include "engine/snch/tree.h"

namespace palpate {

// A triangle with the corners and sides that it owns: every pair of features is then tested on exactly one
// pair of triangles.
inline TestedTriangle owned_triangle(const Tree& tree, const Mesh& mesh, std::uint32_t t) {
  const OwnedFeatures owned = tree.owned(t);
  return {t, triangle_of(mesh, t), owned.corners, owned.sides, owned.near_corners, owned.near_sides};
}

inline TestedTriangle owned_triangle(const Tree& tree, const Mesh& mesh, std::uint32_t t,
                                     const Placement& placement) {
  const OwnedFeatures owned = tree.owned(t);
  return {
      t, triangle_of(mesh, t, placement), owned.corners, owned.sides, owned.near_corners, owned.near_sides};
}

}  // namespace palpate
