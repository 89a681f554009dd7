#pragma once

#include <vector>

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// One cross-section of a loft: a closed curve, counter-clockwise seen against the direction of travel. All
// rings of a loft have the same number of points, and points of one index are joined.
using Ring = std::vector<DVec3>;

// A solid with flat ends, each a fan around the centroid of its ring: 2·points·rings triangles.
TriangleSoup capped_loft(const std::vector<Ring>& rings);

// A solid with a hole: the last ring joins the first. 2·points·rings triangles.
TriangleSoup endless_loft(const std::vector<Ring>& rings);

// centre + u·cos + v·sin with both bent towards a rectangle as the power grows from 2 (an ellipse). u × v
// must point in the direction of travel.
Ring oval_ring(int points, const DVec3& centre, const DVec3& u, const DVec3& v, double power = 2.0);

// A circle across `travel` that starts at `side`; both of unit length and at right angles.
Ring circle_ring(int points, const DVec3& centre, const DVec3& travel, const DVec3& side, double radius);

// Angle of step i of n around a full turn [rad].
double turn(int i, int n);

}  // namespace palpate::shapes
