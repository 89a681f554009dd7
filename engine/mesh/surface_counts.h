#pragma once

#include <vector>

#include "engine/math/vector.h"
#include "engine/mesh/mesh_report.h"
#include "engine/mesh/triangle_soup.h"

namespace palpate {

// Counts a welded surface whose triangles use every one of `positions`.
SurfaceCounts count_surface(const std::vector<Vec3>& positions,
                            const std::vector<TriangleIndices>& triangles);

}  // namespace palpate
