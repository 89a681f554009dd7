#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/groups.h"
#include "engine/mesh/triangle_soup.h"

namespace palpate {

// A side of a triangle. Side k joins corners k and (k + 1) % 3.
struct EdgeUse {
  std::uint32_t far_vertex;  // the larger vertex of the edge
  std::uint32_t code;        // 2 · (3 · triangle + side), plus 1 if the side starts at the smaller vertex

  std::uint32_t triangle() const { return code / 6; }
  std::uint32_t side() const { return code / 2 % 3; }
  bool ascending() const { return code & 1; }

  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

// All sides of a surface, brought together by edge. Triangles with equal corners are left out.
class EdgeUses {
 public:
  static constexpr std::size_t kMaxTriangles = 0xFFFFFFFFu / 6;

  EdgeUses(std::size_t vertex_count, const std::vector<TriangleIndices>& triangles);

  // Calls f(uses) for each edge with its sides in ascending order of triangle.
  template <class F>
  void for_each_edge(const F& f) const {
    for (std::size_t vertex = 0; vertex < by_near_vertex_.size(); ++vertex) {
      std::span<const EdgeUse> rest = by_near_vertex_[vertex];
      while (!rest.empty()) {
        const std::size_t count = uses_of_first(rest);
        f(rest.first(count));
        rest = rest.subspan(count);
      }
    }
  }

 private:
  static std::size_t uses_of_first(std::span<const EdgeUse> uses);

  Groups<EdgeUse> by_near_vertex_;  // the smaller vertex of the edge; sorted within
};

inline std::size_t EdgeUses::uses_of_first(std::span<const EdgeUse> uses) {
  std::size_t count = 1;
  while (count < uses.size() && uses[count].far_vertex == uses[0].far_vertex) ++count;
  return count;
}

}  // namespace palpate
