#pragma once

#include "engine/math/vector.h"

namespace palpate {

// The corners of a triangle, counter-clockwise seen from outside.
struct Triangle {
  DVec3 corner[3];

  const DVec3& start(int side) const { return corner[side]; }
  const DVec3& end(int side) const { return corner[(side + 1) % 3]; }
  DVec3 along(int side) const { return end(side) - start(side); }
  DVec3 area_vector() const { return glm::cross(along(0), corner[2] - corner[0]); }
};

}  // namespace palpate
