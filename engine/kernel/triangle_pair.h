#pragma once

#include <compare>
#include <cstdint>

#include "engine/math/triangle.h"

namespace palpate {

// A place of a triangle: corner k is k, side k (from corner k to corner k + 1) is 3 + k, the face is 6.
struct TrianglePlace {
  std::uint8_t code;

  static constexpr std::uint8_t kFace = 6;
  bool is_corner() const { return code < 3; }
  bool is_side() const { return code >= 3 && code < kFace; }
  int side() const { return code - 3; }

  friend auto operator<=>(const TrianglePlace&, const TrianglePlace&) = default;
};

// The closest points of two triangles, and on which place of each they lie.
struct ClosestPoints {
  double squared_distance;
  DVec3 on_first;
  DVec3 on_second;
  TrianglePlace first_place;
  TrianglePlace second_place;
};

// The closest points of two triangles that do not cross: of all edge pairs and of all corners over the
// other's face. Based on: V. Lumelsky 1985 (segments), E. Larsen et al. 1999 (PQP). Ours tests all fifteen
// feature pairs, without early exits on directions that may be noise, and takes segment parameters in cross
// form.
ClosestPoints closest_points(const Triangle& first, const Triangle& second);

// The triangles have a point in common: a side of one pierces or touches the other, or they overlap in one
// plane.
bool triangles_cross(const Triangle& first, const Triangle& second);

// How far all of `second` is on one side of the plane of `first`; 0 if the plane cuts it.
double plane_gap(const Triangle& first, const Triangle& second);

// The triangles cross or come closer than `gap`. The second form spares measuring again.
bool triangles_touch(const Triangle& first, const Triangle& second, double gap);
bool triangles_touch(const Triangle& first, const Triangle& second, const ClosestPoints& closest, double gap);

}  // namespace palpate
