#include "surface_check.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace palpate::test {
namespace {

using EdgeKey = std::pair<std::uint32_t, std::uint32_t>;

// A triangle at an edge, and whether it runs from the lower to the higher vertex.
struct EdgeUse {
  std::size_t triangle;
  bool ascending;
};

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

bool is_degenerate(const TriangleIndices& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

std::map<EdgeKey, std::vector<EdgeUse>> edges_of(const TriangleSoup& soup) {
  std::map<EdgeKey, std::vector<EdgeUse>> edges;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto& corners = soup.triangles[t];
    if (is_degenerate(corners)) continue;
    for (int k = 0; k < 3; ++k) {
      const auto a = corners[k];
      const auto b = corners[(k + 1) % 3];
      edges[std::minmax(a, b)].push_back({t, a < b});
    }
  }
  return edges;
}

std::size_t count_equal_positions(const TriangleSoup& soup) {
  std::set<std::array<double, 3>> seen;
  for (const auto& p : soup.positions) seen.insert({p.x + 0.0, p.y + 0.0, p.z + 0.0});
  return soup.positions.size() - seen.size();
}

DVec3 normal(const TriangleSoup& soup, std::size_t triangle) {
  const auto& [a, b, c] = soup.triangles[triangle];
  const auto& p = soup.positions;
  return glm::normalize(glm::cross(p[b] - p[a], p[c] - p[a]));
}

// Corner 3t + k of the soup at the given vertex.
std::size_t corner_at(const TriangleSoup& soup, std::size_t triangle, std::uint32_t vertex) {
  const auto& corners = soup.triangles[triangle];
  return 3 * triangle + static_cast<std::size_t>(std::ranges::find(corners, vertex) - corners.begin());
}

// Corners that share a vertex and an edge belong to one fan.
std::size_t count_pinched(const TriangleSoup& soup, const std::map<EdgeKey, std::vector<EdgeUse>>& edges) {
  DisjointSets fans(3 * soup.triangles.size());
  for (const auto& [edge, uses] : edges) {
    for (const auto vertex : {edge.first, edge.second}) {
      for (const auto& use : uses) {
        fans.join(corner_at(soup, use.triangle, vertex), corner_at(soup, uses.front().triangle, vertex));
      }
    }
  }
  std::vector<std::set<std::size_t>> fans_at(soup.positions.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (is_degenerate(soup.triangles[t])) continue;
    for (std::size_t k = 0; k < 3; ++k) fans_at[soup.triangles[t][k]].insert(fans.find(3 * t + k));
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(fans_at, [](const auto& fan) { return fan.size() > 1; }));
}

std::vector<double> component_volumes(const TriangleSoup& soup) {
  DisjointSets components(soup.positions.size());
  for (const auto& [a, b, c] : soup.triangles) {
    components.join(a, b);
    components.join(b, c);
  }
  std::map<std::size_t, double> volume_of;
  for (const auto& [a, b, c] : soup.triangles) {
    const auto& p = soup.positions;
    volume_of[components.find(a)] += glm::dot(p[a], glm::cross(p[b], p[c])) / 6.0;
  }
  std::vector<double> volumes;
  for (const auto& [root, volume] : volume_of) volumes.push_back(volume);
  return volumes;
}

}  // namespace

SurfaceCheck check_surface(const TriangleSoup& soup) {
  SurfaceCheck check;
  check.equal_positions = count_equal_positions(soup);
  check.degenerate_triangles = static_cast<std::size_t>(std::ranges::count_if(soup.triangles, is_degenerate));
  const auto edges = edges_of(soup);
  for (const auto& [edge, uses] : edges) {
    check.boundary_edges += uses.size() == 1;
    check.nonmanifold_edges += uses.size() > 2;
    if (uses.size() != 2) continue;
    check.inconsistent_edges += uses[0].ascending == uses[1].ascending;
    const double cosine = glm::dot(normal(soup, uses[0].triangle), normal(soup, uses[1].triangle));
    check.sharpest_edge = std::min(check.sharpest_edge, cosine);
  }
  check.pinched_vertices = count_pinched(soup, edges);
  check.volumes = component_volumes(soup);
  return check;
}

double worst_aspect(const TriangleSoup& soup) {
  double worst = 0.0;
  for (const auto& [a, b, c] : soup.triangles) {
    const DVec3 ab = soup.positions[b] - soup.positions[a];
    const DVec3 ac = soup.positions[c] - soup.positions[a];
    const DVec3 bc = ac - ab;
    const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    const double twice_area = glm::length(glm::cross(ab, ac));
    if (twice_area > 0.0) worst = std::max(worst, longest / twice_area);
  }
  return worst;
}

}  // namespace palpate::test
