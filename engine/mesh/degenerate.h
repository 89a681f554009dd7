#pragma once

#include "engine/mesh/clean_triangles.h"

namespace palpate {

inline bool has_equal_corners(const TriangleIndices& triangle) {
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

// Whether the corners lie on one line, exactly.
bool has_no_area(const std::vector<Vec3>& positions, const TriangleIndices& triangle);

// Drops triangles with two equal corners, then those of zero area without opening a seam where one can be
// kept shut (slivers.h). Counts both, and the neighbours that were split.
void drop_degenerate(CleanTriangles& surface, MeshReport& report);

}  // namespace palpate
