// The winding number of a closed surface around a point as the signed count of its crossings with a half-line
// from the point; the half-open crossing rule of each projected side is that of D. Sunday, "Inclusion of a
// Point in a Polygon" (2001). Unlike a sum of solid angles (van Oosterom & Strackee 1983) it is an integer
// and serves many points at once: each triangle visits only the points in its shadow.
#include "engine/mesh/line_crossings.h"

#include <algorithm>
#include <array>

namespace palpate {
namespace {

// The half-line leans, because the walls and edges of CAD models run along the axes and would hide behind
// each other.
constexpr double kLeanX = 0.2871937, kLeanY = 0.1730519;

// More than rounding moves a probe across a side, for coordinates of order one. A tie that is broken in
// favour of a triangle must find that triangle among those that are looked at.
constexpr double kTie = 1e-12;

DVec3 sheared(const DVec3& p) {
  return {p.x + kLeanX * p.z, p.y + kLeanY * p.z, p.z};
}

struct Probe {
  DVec3 at;  // sheared, so that the half-line runs along +z
  std::size_t index;
};

struct Corner {
  std::uint32_t vertex;
  DVec3 at;  // sheared
};

// What the side adds to the winding of a projected triangle around the probe. Which side of it the probe is
// on is computed from the undirected side, so both triangles of an edge get the same answer even where it is
// a tie.
int side_crossing(const Corner& from, const Corner& to, const DVec3& probe) {
  const bool upward = to.at.y > probe.y;
  if ((from.at.y > probe.y) == upward) return 0;
  const bool swapped = to.vertex < from.vertex;
  const DVec3 &low = swapped ? to.at : from.at, &high = swapped ? from.at : to.at;
  const double turn = (high.x - low.x) * (probe.y - low.y) - (high.y - low.y) * (probe.x - low.x);
  const bool left = (turn >= 0) != swapped;
  return upward && left ? 1 : !upward && !left ? -1 : 0;
}

bool is_above(const std::array<Corner, 3>& triangle, const DVec3& probe) {
  const DVec3 normal = glm::cross(triangle[1].at - triangle[0].at, triangle[2].at - triangle[0].at);
  return glm::dot(normal, triangle[0].at - probe) * normal.z > 0;
}

int crossing(const std::array<Corner, 3>& triangle, const DVec3& probe) {
  int winding = 0;
  for (int side = 0; side < 3; ++side)
    winding += side_crossing(triangle[side], triangle[(side + 1) % 3], probe);
  return winding != 0 && is_above(triangle, probe) ? winding : 0;
}

std::vector<Probe> sorted_probes(std::span<const DVec3> points) {
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < points.size(); ++i) probes.push_back({sheared(points[i]), i});
  std::ranges::sort(probes, {}, [](const Probe& probe) { return probe.at.x; });
  return probes;
}

}  // namespace

std::vector<int> winding_numbers(const ClosedSurface& surface, std::span<const DVec3> points) {
  const std::vector<Probe> probes = sorted_probes(points);
  std::vector<int> windings(points.size(), 0);
  for (std::uint32_t t : surface.part) {
    std::array<Corner, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = surface.triangles[t][k];
      triangle[k] = {vertex, sheared(DVec3(surface.positions[vertex]))};
    }
    const auto [low, high] = std::minmax({triangle[0].at.x, triangle[1].at.x, triangle[2].at.x});
    auto probe = std::ranges::lower_bound(probes, low - kTie, {}, [](const Probe& p) { return p.at.x; });
    for (; probe != probes.end() && probe->at.x <= high + kTie; ++probe)
      windings[probe->index] += crossing(triangle, probe->at);
  }
  return windings;
}

}  // namespace palpate
