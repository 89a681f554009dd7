#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/triangle_soup.h"

namespace palpate::gltf {

// glTF's primitive modes that hold triangles.
enum class TriangleMode { kList, kStrip, kFan };

// The triangles of a primitive, by the rules of glTF 2.0, section 3.7.2.1. Corners that are left over are
// dropped.
std::vector<TriangleIndices> list_triangles(const std::vector<std::uint32_t>& corners, TriangleMode mode);

// How many that will be.
std::uint64_t count_triangles(std::uint64_t corners, TriangleMode mode);

}  // namespace palpate::gltf
