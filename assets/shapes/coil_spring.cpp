#include "assets/shapes/coil_spring.h"

#include <cmath>
#include <numbers>

#include "assets/shapes/loft.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {

TriangleSoup coil_spring(int rings, int across) {
  constexpr double kCoilRadius = 0.03;
  constexpr double kWireRadius = 0.004;
  constexpr double kTurns = 7.5;
  constexpr double kRise = 0.1 - 2.0 * kWireRadius;
  constexpr double kSweep = 2.0 * std::numbers::pi * kTurns;
  std::vector<Ring> sections;
  for (int i = 0; i < rings; ++i) {
    const double along = static_cast<double>(i) / (rings - 1);
    const double angle = kSweep * along;
    const DVec3 outward(std::cos(angle), std::sin(angle), 0.0);
    const DVec3 centre = kCoilRadius * outward + DVec3(0.0, 0.0, kRise * (along - 0.5));
    const DVec3 travel =
        glm::normalize(DVec3(-outward.y * kCoilRadius, outward.x * kCoilRadius, kRise / kSweep));
    sections.push_back(circle_ring(across, centre, travel, outward, kWireRadius));
  }
  return rounded_to_float32(capped_loft(sections));
}

}  // namespace palpate::shapes
