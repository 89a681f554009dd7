#include "engine/mesh/slivers.h"

#include <algorithm>
#include <deque>
#include <unordered_map>

namespace palpate {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

// Ends because every step removes slivers, or (where two lie on each other's longest edge) turns two
// into two whose longest edges are both shorter.
class SliverSplitter {
 public:
  SliverSplitter(CleanTriangles& surface, const std::vector<std::uint32_t>& slivers);

  std::uint64_t run();

 private:
  bool tracked(std::uint32_t a, std::uint32_t b) const { return near_sliver_[a] && near_sliver_[b]; }
  std::vector<std::uint32_t>& uses(std::uint32_t a, std::uint32_t b) {
    return uses_[std::uint64_t{std::min(a, b)} << 32 | std::max(a, b)];
  }
  template <class F>
  void for_each_tracked_edge(std::uint32_t t, const F& f);
  void attach(std::uint32_t t);
  void detach(std::uint32_t t);
  void wake(const std::vector<std::uint32_t>& triangles);
  void resolve(std::uint32_t sliver);
  void retire(std::uint32_t sliver);
  void split(std::uint32_t t, std::uint32_t side, std::uint32_t middle);
  std::uint32_t middle_corner(std::uint32_t sliver) const;
  std::uint32_t other_on_edge(std::uint32_t sliver, std::uint32_t a, std::uint32_t c);
  std::uint32_t side_of(std::uint32_t t, std::uint32_t a, std::uint32_t c) const;

  enum class Kind : std::uint8_t { kSolid, kSliver, kResolved };

  CleanTriangles& surface_;
  std::vector<Kind> kinds_;
  std::vector<bool> near_sliver_;  // by vertex: a sliver has it as a corner
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> uses_;  // by edge between two such vertices
  std::deque<std::uint32_t> queue_;
  std::uint64_t split_solids_ = 0;
};

SliverSplitter::SliverSplitter(CleanTriangles& surface, const std::vector<std::uint32_t>& slivers)
    : surface_(surface),
      kinds_(surface.triangles.size(), Kind::kSolid),
      near_sliver_(surface.positions.size()) {
  for (std::uint32_t sliver : slivers)
    for (std::uint32_t vertex : surface.triangles[sliver]) near_sliver_[vertex] = true;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) attach(t);
  for (std::uint32_t sliver : slivers) kinds_[sliver] = Kind::kSliver;
  queue_.assign(slivers.begin(), slivers.end());
}

std::uint64_t SliverSplitter::run() {
  while (!queue_.empty()) {
    const std::uint32_t sliver = queue_.front();
    queue_.pop_front();
    if (kinds_[sliver] == Kind::kSliver) resolve(sliver);
  }
  return split_solids_;
}

template <class F>
void SliverSplitter::for_each_tracked_edge(std::uint32_t t, const F& f) {
  const TriangleIndices triangle = surface_.triangles[t];
  for (int side = 0; side < 3; ++side) {
    const std::uint32_t a = triangle[side], b = triangle[(side + 1) % 3];
    if (tracked(a, b)) f(uses(a, b));
  }
}

void SliverSplitter::attach(std::uint32_t t) {
  for_each_tracked_edge(t, [&](std::vector<std::uint32_t>& uses) {
    uses.push_back(t);
    wake(uses);
  });
}

void SliverSplitter::detach(std::uint32_t t) {
  for_each_tracked_edge(t, [&](std::vector<std::uint32_t>& uses) {
    std::erase(uses, t);
    wake(uses);
  });
}

// A sliver may become resolvable whenever the triangles around one of its edges change.
void SliverSplitter::wake(const std::vector<std::uint32_t>& triangles) {
  if (triangles.size() != 2) return;
  for (std::uint32_t t : triangles)
    if (kinds_[t] == Kind::kSliver) queue_.push_back(t);
}

// The corner between the other two.
std::uint32_t SliverSplitter::middle_corner(std::uint32_t sliver) const {
  const TriangleIndices& triangle = surface_.triangles[sliver];
  for (std::uint32_t k = 0; k < 3; ++k) {
    const DVec3 middle(surface_.positions[triangle[k]]);
    const DVec3 to_next = DVec3(surface_.positions[triangle[(k + 1) % 3]]) - middle;
    const DVec3 to_last = DVec3(surface_.positions[triangle[(k + 2) % 3]]) - middle;
    if (glm::dot(to_next, to_last) < 0) return k;
  }
  return kNone;
}

// The side that joins a and c.
std::uint32_t SliverSplitter::side_of(std::uint32_t t, std::uint32_t a, std::uint32_t c) const {
  const TriangleIndices& triangle = surface_.triangles[t];
  std::uint32_t side = 0;
  while (triangle[(side + 2) % 3] == a || triangle[(side + 2) % 3] == c) ++side;
  return side;
}

// The one other triangle on edge ac of the sliver, or kNone.
std::uint32_t SliverSplitter::other_on_edge(std::uint32_t sliver, std::uint32_t a, std::uint32_t c) {
  const std::vector<std::uint32_t>& around = uses(a, c);
  if (around.size() != 2) return kNone;
  return around[0] == sliver ? around[1] : around[0];
}

void SliverSplitter::resolve(std::uint32_t sliver) {
  const std::uint32_t middle = middle_corner(sliver);
  if (middle == kNone) return;
  const TriangleIndices triangle = surface_.triangles[sliver];
  const std::uint32_t a = triangle[(middle + 1) % 3], b = triangle[middle], c = triangle[(middle + 2) % 3];
  const std::uint32_t other = other_on_edge(sliver, a, c);
  if (other == kNone) return;
  const std::uint32_t side = side_of(other, a, c), far_corner = (side + 2) % 3;
  if (surface_.triangles[other][far_corner] == b) {
    retire(sliver);  // two slivers back to back cancel
    retire(other);
  } else if (kinds_[other] == Kind::kSolid || middle_corner(other) == far_corner) {
    retire(sliver);
    split(other, side, b);
  }
}

void SliverSplitter::retire(std::uint32_t sliver) {
  kinds_[sliver] = Kind::kResolved;
  detach(sliver);
}

void SliverSplitter::split(std::uint32_t t, std::uint32_t side, std::uint32_t middle) {
  detach(t);
  const auto half = static_cast<std::uint32_t>(surface_.triangles.size());
  surface_.triangles.push_back(surface_.triangles[t]);
  surface_.double_sided.push_back(surface_.double_sided[t]);
  surface_.source.push_back(surface_.source[t]);
  kinds_.push_back(kinds_[t]);
  surface_.triangles[t][(side + 1) % 3] = middle;
  surface_.triangles[half][side] = middle;
  if (kinds_[t] == Kind::kSolid) ++split_solids_;
  attach(t);
  attach(half);
}

}  // namespace

std::uint64_t split_beside_slivers(CleanTriangles& surface, const std::vector<std::uint32_t>& slivers) {
  return SliverSplitter(surface, slivers).run();
}

}  // namespace palpate
