#include "engine/mesh/patches.h"

#include <array>

namespace palpate {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

// What lies across a side: 2 · triangle, plus 1 if both triangles run the same way along it; or kNone.
using Neighbours = std::vector<std::array<std::uint32_t, 3>>;

Neighbours neighbours_of(const EdgeUses& edges, std::size_t triangle_count) {
  Neighbours neighbours(triangle_count, {kNone, kNone, kNone});
  edges.for_each_edge([&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const bool same_way = uses[0].ascending() == uses[1].ascending();
    neighbours[uses[0].triangle()][uses[0].side()] = 2 * uses[1].triangle() + same_way;
    neighbours[uses[1].triangle()][uses[1].side()] = 2 * uses[0].triangle() + same_way;
  });
  return neighbours;
}

class PatchFinder {
 public:
  PatchFinder(const EdgeUses& edges, std::size_t triangle_count)
      : neighbours_(neighbours_of(edges, triangle_count)) {
    patches_.of_triangle.assign(triangle_count, kNone);
    patches_.turned.resize(triangle_count);
    patches_.triangles.items.reserve(triangle_count);
    patches_.triangles.begin.push_back(0);
  }

  Patches run() {
    for (std::uint32_t t = 0; t < patches_.of_triangle.size(); ++t)
      if (patches_.of_triangle[t] == kNone) find_from(t);
    return std::move(patches_);
  }

 private:
  void find_from(std::uint32_t seed) {
    std::vector<std::uint32_t>& found = patches_.triangles.items;
    const auto patch = static_cast<std::uint32_t>(patches_.triangles.size());
    const std::size_t begin = found.size();
    bool consistent = true;
    patches_.of_triangle[seed] = patch;
    found.push_back(seed);
    for (std::size_t i = begin; i < found.size(); ++i) consistent &= visit_neighbours(found[i]);
    patches_.triangles.begin.push_back(static_cast<std::uint32_t>(found.size()));
    if (consistent) return;
    ++patches_.one_sided;
    for (std::uint32_t t : patches_.triangles[patch]) patches_.turned[t] = false;
  }

  // Adds the neighbours of `t` to its patch; false if one that is in it already is wound the wrong way.
  bool visit_neighbours(std::uint32_t t) {
    bool consistent = true;
    for (std::uint32_t code : neighbours_[t]) {
      if (code == kNone) continue;
      const std::uint32_t neighbour = code / 2;
      const bool turned = patches_.turned[t] != static_cast<bool>(code & 1);
      if (patches_.of_triangle[neighbour] == kNone) {
        patches_.of_triangle[neighbour] = patches_.of_triangle[t];
        patches_.turned[neighbour] = turned;
        patches_.triangles.items.push_back(neighbour);
      } else if (patches_.turned[neighbour] != turned) {
        consistent = false;
      }
    }
    return consistent;
  }

  Neighbours neighbours_;
  Patches patches_;
};

}  // namespace

Patches patches_of(const EdgeUses& edges, std::size_t triangle_count) {
  return PatchFinder(edges, triangle_count).run();
}

}  // namespace palpate
