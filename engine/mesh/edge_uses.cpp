#include "engine/mesh/edge_uses.h"

#include <algorithm>

#include "engine/mesh/degenerate.h"

namespace palpate {

EdgeUses::EdgeUses(std::size_t vertex_count, const std::vector<TriangleIndices>& triangles) {
  by_near_vertex_ = group_items<EdgeUse>(vertex_count, [&](const auto& emit) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const TriangleIndices& triangle = triangles[t];
      if (has_equal_corners(triangle)) continue;
      for (std::uint32_t side = 0; side < 3; ++side) {
        const std::uint32_t from = triangle[side], to = triangle[(side + 1) % 3];
        const std::uint32_t corner = 3 * t + side;
        emit(std::min(from, to), EdgeUse{std::max(from, to), 2 * corner + (from < to)});
      }
    }
  });
  for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) std::ranges::sort(by_near_vertex_[vertex]);
}

}  // namespace palpate
