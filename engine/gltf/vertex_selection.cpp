#include "engine/gltf/vertex_selection.h"

#include <algorithm>

namespace palpate::gltf {

VertexSelection::VertexSelection(std::size_t vertices, std::vector<TriangleIndices>& triangles)
    : vertices_(vertices), all_(vertices <= 3 * triangles.size()) {
  if (all_) return;
  used_.reserve(3 * triangles.size());
  for (const TriangleIndices& triangle : triangles)
    used_.insert(used_.end(), triangle.begin(), triangle.end());
  std::sort(used_.begin(), used_.end());
  used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
  for (TriangleIndices& triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      const auto found = std::lower_bound(used_.begin(), used_.end(), corner);
      corner = static_cast<std::uint32_t>(found - used_.begin());
    }
  }
}

}  // namespace palpate::gltf
