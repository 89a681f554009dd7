#pragma once

#include "engine/kernel/triangle.h"

namespace palpate {

// The closest points of two triangles.
struct ClosestPoints {
  double squared_distance;
  DVec3 on_first;
  DVec3 on_second;
};

// The closest points of two triangles that do not cross: of all edge pairs and of all corners over the
// other's face. Based on: V. Lumelsky 1985 (segments), E. Larsen et al. 1999 (PQP). Ours tests all fifteen
// feature pairs, without early exits on directions that may be noise, and takes segment parameters in cross
// form.
ClosestPoints closest_points(const Triangle& first, const Triangle& second);

// The triangles have a point in common: a side of one pierces or touches the other, or they overlap in one
// plane.
bool triangles_cross(const Triangle& first, const Triangle& second);

// The plane of `first` has all of `second` on one side of it, farther away than `gap`.
bool plane_parts(const Triangle& first, const Triangle& second, double gap);

}  // namespace palpate
