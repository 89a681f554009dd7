#pragma once

#include <glm/geometric.hpp>

#include "engine/math/triangle.h"

namespace palpate::exact {

using Real = long double;
using Real3 = glm::vec<3, Real>;

inline Real3 real(const DVec3& v) {
  return Real3(v);
}

// The distance of two triangles that do not cross, in long double, another way than the engine's.
struct Distance {
  Real value;
  Real gap;  // between the planes at right angles to the points' direction that hold the triangles: no less
             // than the distance proves it; negative where the triangles cross
};

Distance distance(const Triangle& a, const Triangle& b);

Real distance_to_segment(const Real3& point, const Real3& from, const Real3& to);
Real distance_to_triangle(const Real3& point, const Triangle& triangle);

}  // namespace palpate::exact
