#include "assets/shapes/round_solids.h"

#include <cmath>

#include "assets/shapes/loft.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {

TriangleSoup cylinder(double radius, double height, int segments, int rings) {
  std::vector<Ring> sections;
  for (int i = 0; i < rings; ++i) {
    const double z = height * (static_cast<double>(i) / (rings - 1) - 0.5);
    sections.push_back(oval_ring(segments, {0, 0, z}, {radius, 0, 0}, {0, radius, 0}));
  }
  return rounded_to_float32(capped_loft(sections));
}

TriangleSoup torus(double ring_radius, double tube_radius, int around, int across) {
  std::vector<Ring> sections;
  for (int i = 0; i < around; ++i) {
    const DVec3 outward(std::cos(turn(i, around)), std::sin(turn(i, around)), 0.0);
    const DVec3 travel(-outward.y, outward.x, 0.0);
    sections.push_back(circle_ring(across, outward * ring_radius, travel, outward, tube_radius));
  }
  return rounded_to_float32(endless_loft(sections));
}

TriangleSoup fan(int valence) {
  constexpr double kRadius = 0.1;
  constexpr double kHeight = 0.01;
  TriangleSoup soup;
  soup.positions = oval_ring(valence, {0, 0, 0}, {kRadius, 0, 0}, {0, kRadius, 0});
  const auto n = static_cast<std::uint32_t>(valence);
  soup.positions.emplace_back(0.0, 0.0, kHeight);
  soup.positions.emplace_back(0.0, 0.0, 0.0);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    soup.triangles.push_back({n, i, next});
    soup.triangles.push_back({n + 1, next, i});
  }
  return rounded_to_float32(std::move(soup));
}

}  // namespace palpate::shapes
