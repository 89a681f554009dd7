#include "engine/mesh/nesting.h"

#include <algorithm>
#include <numeric>

#include "engine/mesh/line_crossings.h"

namespace palpate {
namespace {

bool contains(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
         glm::all(glm::greaterThanEqual(outer.high, inner.high));
}

// For each shell the smaller ones whose boxes lie within its box: a sweep along x.
std::vector<std::vector<std::uint32_t>> boxed_shells(const std::vector<Shell>& shells) {
  std::vector<std::uint32_t> order(shells.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return shells[i].box.low.x; });
  std::vector<std::vector<std::uint32_t>> boxed(shells.size());
  std::vector<std::uint32_t> open;
  for (std::uint32_t next : order) {
    std::erase_if(open, [&](std::uint32_t i) { return shells[i].box.high.x < shells[next].box.low.x; });
    for (std::uint32_t other : open) {
      const auto [outer, inner] = std::minmax(next, other);
      if (contains(shells[outer].box, shells[inner].box)) boxed[outer].push_back(inner);
    }
    open.push_back(next);
  }
  return boxed;
}

// A point inside a face is on a neighbouring shell less often than a vertex is.
DVec3 probe_of(const std::vector<Vec3>& positions, const TriangleIndices& triangle) {
  return (DVec3(positions[triangle[0]]) + DVec3(positions[triangle[1]]) + DVec3(positions[triangle[2]])) /
         3.0;
}

}  // namespace

std::vector<std::uint32_t> enclosing_shells(const std::vector<Vec3>& positions,
                                            const std::vector<TriangleIndices>& triangles,
                                            const std::vector<Shell>& shells) {
  std::vector<std::uint32_t> parents(shells.size(), kNoShell);
  const std::vector<std::vector<std::uint32_t>> boxed = boxed_shells(shells);
  for (std::uint32_t outer = 0; outer < shells.size(); ++outer) {
    if (boxed[outer].empty()) continue;
    std::vector<DVec3> probes;
    for (std::uint32_t inner : boxed[outer])
      probes.push_back(probe_of(positions, triangles[shells[inner].triangles.front()]));
    const std::vector<int> windings =
        winding_numbers({positions, triangles, shells[outer].triangles}, probes);
    // Later shells are smaller, so the last one that contains a shell is the innermost.
    for (std::size_t i = 0; i < windings.size(); ++i)
      if (windings[i] != 0) parents[boxed[outer][i]] = outer;
  }
  return parents;
}

}  // namespace palpate
