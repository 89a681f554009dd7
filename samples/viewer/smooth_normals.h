#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "samples/viewer/geometry.h"

namespace palpate::viewer {

// A normal for each corner of each triangle: smooth over flat edges, broken over sharp ones.
std::vector<glm::vec3> smooth_normals(const std::vector<Vec3>& vertices,
                                      const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace palpate::viewer
