#include "engine/snch/packed_node.h"

#include <array>

namespace palpate {
namespace {

// Where a unit direction is in the square, −1 to 1.
std::array<double, 2> unfolded(const DVec3& axis) {
  const double size = std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z);
  const double x = axis.x / size, y = axis.y / size;
  if (axis.z >= 0) return {x, y};
  return {std::copysign(1.0 - std::abs(y), x), std::copysign(1.0 - std::abs(x), y)};
}

}  // namespace

void PackedNode::set_box(const DVec3& half_size, double sphere_radius) {
  low_bits = 0;
  const auto upper = [this](double length, int low) {
    const std::uint32_t code = FloatCode::rounded_up(length);
    low_bits = static_cast<std::uint16_t>(low_bits | (code & 15u) << low);
    return static_cast<std::uint16_t>(code >> 4);
  };
  for (int k = 0; k < 3; ++k) half[k] = upper(half_size[k], 4 * k);
  radius = upper(sphere_radius, 12);
}

// Wider by as much as its axis is turned.
void PackedNode::set_cone(const Cone& around) {
  const std::array<double, 2> place = unfolded(around.axis);
  for (int k = 0; k < 2; ++k)
    octant[k] = static_cast<std::uint16_t>(std::lround(place[k] * kOctantCentre) + kOctantCentre);
  const Cone kept = around.widened(half_tangent_across(glm::length(DVec3(cone_axis()) - around.axis)));
  const std::uint32_t code = FloatCode::rounded_up(std::min(kept.half_tangent, 1.0), 4) >> 4;
  cone = code < kRightAngle ? static_cast<std::uint16_t>(code) : kWhole;
}

}  // namespace palpate
