#pragma once

#include "tests/stress/real.h"

namespace palpate::stress {

struct ExactTriangle {
  RVec3 corner[3];

  const RVec3& start(int side) const { return corner[side]; }
  RVec3 along(int side) const { return corner[(side + 1) % 3] - corner[side]; }
  RVec3 area() const { return cross(along(0), corner[2] - corner[0]); }
  Real longest_side() const { return std::max({length(along(0)), length(along(1)), length(along(2))}); }
};

// The closest points of two triangles. A place is a corner (0 to 2), a side (3 to 5) or the face (6).
struct ExactClosest {
  Real distance;
  RVec3 on_a;
  RVec3 on_b;
  int place_a;
  int place_b;
  Real margin;  // of both points from the next lower place
};

// Reference for distances: all fifteen pairs of features, in 113 bits. 0 where triangles cross.
ExactClosest exact_closest(const ExactTriangle& a, const ExactTriangle& b);

// A side of one crosses or touches the other, of triangles that are not in one plane.
bool exact_crossing(const ExactTriangle& a, const ExactTriangle& b);

}  // namespace palpate::stress
