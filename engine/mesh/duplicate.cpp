#include "engine/mesh/duplicate.h"

#include <algorithm>
#include <compare>

#include "engine/mesh/groups.h"
#include "engine/mesh/triangle_filter.h"

namespace palpate {
namespace {

// A triangle among those with the same lowest vertex.
struct SortedTriangle {
  std::uint32_t middle_vertex;
  std::uint32_t high_vertex;
  std::uint32_t index;

  friend auto operator<=>(const SortedTriangle&, const SortedTriangle&) = default;
};

Groups<SortedTriangle> by_lowest_vertex(const CleanTriangles& surface) {
  return group_items<SortedTriangle>(surface.positions.size(), [&](const auto& emit) {
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      TriangleIndices sorted = surface.triangles[t];
      std::ranges::sort(sorted);
      emit(sorted[0], SortedTriangle{sorted[1], sorted[2], t});
    }
  });
}

// Whether the vertices ascend when read from the lowest one on.
bool ascends(const TriangleIndices& triangle) {
  return (triangle[0] < triangle[1]) + (triangle[1] < triangle[2]) + (triangle[2] < triangle[0]) == 2;
}

}  // namespace

void drop_duplicates(CleanTriangles& surface, MeshReport& report) {
  Groups<SortedTriangle> groups = by_lowest_vertex(surface);
  std::vector<bool> dropped(surface.triangles.size());
  for (std::size_t vertex = 0; vertex < groups.size(); ++vertex) {
    const std::span<SortedTriangle> group = groups[vertex];
    std::ranges::sort(group);
    std::size_t kept = 0;
    for (std::size_t i = 1; i < group.size(); ++i) {
      const SortedTriangle &first = group[kept], &next = group[i];
      if (first.middle_vertex != next.middle_vertex || first.high_vertex != next.high_vertex) {
        kept = i;
        continue;
      }
      dropped[next.index] = true;
      if (surface.double_sided[next.index] ||
          ascends(surface.triangles[first.index]) != ascends(surface.triangles[next.index]))
        surface.double_sided[first.index] = true;
    }
  }
  report.duplicate_triangles = drop_triangles(surface, dropped);
}

}  // namespace palpate
