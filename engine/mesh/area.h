#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/vector.h"
#include "engine/mesh/triangle_soup.h"

namespace palpate {

// Normal of a triangle with twice its area for length. Differences of float32 coordinates and their products
// fit float64 (unless their magnitudes are over 2^28 apart), so it is exactly zero if the corners are
// collinear.
inline DVec3 area_vector(const std::vector<Vec3>& positions, const TriangleIndices& triangle) {
  const DVec3 a(positions[triangle[0]]);
  return glm::cross(DVec3(positions[triangle[1]]) - a, DVec3(positions[triangle[2]]) - a);
}

// Six times the volume between a triangle and `apex`, positive if the triangle faces away from it.
inline double apex_volume(const std::vector<Vec3>& positions, const TriangleIndices& triangle,
                          const DVec3& apex) {
  return glm::dot(area_vector(positions, triangle), DVec3(positions[triangle[0]]) - apex);
}

}  // namespace palpate
