#include "engine/mesh/triangle_filter.h"

#include <limits>

namespace palpate {

std::size_t drop_triangles(CleanTriangles& surface, const std::vector<bool>& dropped) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < dropped.size(); ++t) {
    if (dropped[t]) continue;
    surface.triangles[kept] = surface.triangles[t];
    surface.double_sided[kept] = surface.double_sided[t];
    surface.source[kept] = surface.source[t];
    ++kept;
  }
  surface.triangles.resize(kept);
  surface.double_sided.resize(kept);
  surface.source.resize(kept);
  return dropped.size() - kept;
}

void drop_unused_vertices(CleanTriangles& surface) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number_of(surface.positions.size(), kUnused);
  std::vector<Vec3> used;
  used.reserve(surface.positions.size());
  for (TriangleIndices& triangle : surface.triangles) {
    for (std::uint32_t& vertex : triangle) {
      if (number_of[vertex] == kUnused) {
        number_of[vertex] = static_cast<std::uint32_t>(used.size());
        used.push_back(surface.positions[vertex]);
      }
      vertex = number_of[vertex];
    }
  }
  surface.positions = std::move(used);
}

}  // namespace palpate
