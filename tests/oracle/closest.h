#pragma once

#include "tests/oracle/surface.h"

namespace palpate::oracle {

// The closest points of two triangles, and which place of each they lie on.
struct Closest {
  double distance;
  DVec3 on_a;
  DVec3 on_b;
  Place place_a;
  Place place_b;
  double margin;  // distance of both points from the next lower place
};

// Corners of triangle `t` at a pose.
struct Corners {
  DVec3 at[3];
};

Closest closest(const Surface& a, TriangleIndex in_a, const Corners& corners_a, const Surface& b,
                TriangleIndex in_b, const Corners& corners_b);

// A side of one crosses the other.
bool crossing(const Corners& a, const Corners& b);

}  // namespace palpate::oracle
