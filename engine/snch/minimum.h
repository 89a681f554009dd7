#pragma once

#include <tuple>

#include "engine/math/vector.h"
#include "engine/mesh/mesh.h"

namespace palpate {

// A pair of features that holds a local minimum distance, as the leaf tests find it: one point of what may be
// a plateau. A's normalised frame.
struct Minimum {
  Feature feature_a;
  Feature feature_b;
  DVec3 point_a;
  DVec3 point_b;
  DVec3 normal;  // unit vector from point_a to point_b
  double distance;
  double violation;  // largest lean outside a polar cone: within the tolerance
  bool alone;  // so far inside its polar cones and its features that no other can be of the same plateau
  bool inset;  // near the corner of a plateau's cell rather than on it
};

// An order that does not depend on how the minima were found.
inline bool precedes(const Minimum& one, const Minimum& other) {
  const auto key = [](const Minimum& m) {
    return std::tie(m.feature_a, m.feature_b, m.point_b.x, m.point_b.y, m.point_b.z);
  };
  return key(one) < key(other);
}

}  // namespace palpate
