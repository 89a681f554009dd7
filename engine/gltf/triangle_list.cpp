#include "engine/gltf/triangle_list.h"

namespace palpate::gltf {

std::uint64_t count_triangles(std::uint64_t corners, TriangleMode mode) {
  if (mode == TriangleMode::kList) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

std::vector<TriangleIndices> list_triangles(const std::vector<std::uint32_t>& corners, TriangleMode mode) {
  const std::uint64_t count = count_triangles(corners.size(), mode);
  std::vector<TriangleIndices> triangles;
  triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    switch (mode) {
      case TriangleMode::kList:
        triangles.push_back({corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]});
        break;
      case TriangleMode::kStrip:
        triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
        break;
      case TriangleMode::kFan:
        triangles.push_back({corners[i + 1], corners[i + 2], corners[0]});
        break;
    }
  }
  return triangles;
}

}  // namespace palpate::gltf
