#include "engine/mesh/surface_counts.h"

#include <algorithm>
#include <numeric>

#include "engine/mesh/area.h"
#include "engine/mesh/edge_uses.h"

namespace palpate {
namespace {

// Sets that are joined pair by pair; a set is known by its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  std::uint64_t count() const {
    std::uint64_t roots = 0;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) roots += parent_[i] == i;
    return roots;
  }

 private:
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::vector<std::uint32_t> parent_;
};

void count_edges(const EdgeUses& edges, SurfaceCounts& counts) {
  edges.for_each_edge([&](std::span<const EdgeUse> uses) {
    ++counts.edges;
    if (uses.size() == 1) ++counts.boundary_edges;
    if (uses.size() > 2) ++counts.nonmanifold_edges;
    if (uses.size() == 2 && uses[0].ascending() == uses[1].ascending()) ++counts.inconsistent_edges;
  });
}

std::uint64_t count_components(std::size_t vertices, const std::vector<TriangleIndices>& triangles) {
  DisjointSets sets(vertices);
  for (const TriangleIndices& triangle : triangles) {
    sets.join(triangle[0], triangle[1]);
    sets.join(triangle[0], triangle[2]);
  }
  return sets.count();
}

Orientation orientation_of(const std::vector<Vec3>& positions, const std::vector<TriangleIndices>& triangles,
                           const SurfaceCounts& counts) {
  if (counts.inconsistent_edges > 0) return Orientation::kMixed;
  if (!counts.watertight()) return Orientation::kOpen;
  double volume = 0;
  for (const TriangleIndices& triangle : triangles)
    volume += apex_volume(positions, triangle, DVec3(positions[0]));
  return volume > 0 ? Orientation::kOutward : volume < 0 ? Orientation::kInward : Orientation::kOpen;
}

}  // namespace

SurfaceCounts count_surface(const std::vector<Vec3>& positions,
                            const std::vector<TriangleIndices>& triangles) {
  SurfaceCounts counts;
  counts.triangles = triangles.size();
  counts.vertices = positions.size();
  counts.components = count_components(positions.size(), triangles);
  count_edges(EdgeUses(positions.size(), triangles), counts);
  counts.orientation = orientation_of(positions, triangles, counts);
  return counts;
}

}  // namespace palpate
