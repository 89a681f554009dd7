#pragma once

#include <cmath>

#include "engine/math/vector.h"

namespace palpate {

// The tangent of half the angle between two unit vectors whose ends are `chord` apart. Accurate for small
// angles.
inline double half_tangent_across(double chord) {
  const double sine = 0.5 * chord;
  return sine < 1.0 ? sine / std::sqrt(1.0 - sine * sine) : 1e300;
}

// The unit directions within an angle of an axis. The angle is at most a right angle, or the cone is `whole`.
struct Cone {
  DVec3 axis{0.0, 0.0, 1.0};
  double half_tangent = kWhole;  // of half the angle

  static constexpr double kWhole = 2.0;
  static Cone whole() { return {}; }
  bool is_whole() const { return half_tangent > 1.0; }

  // By an angle that is given in the same way.
  Cone widened(double by) const {
    const double product = half_tangent * by;
    const double sum = product < 1.0 ? (half_tangent + by) / (1.0 - product) : kWhole;
    return is_whole() || sum > 1.0 ? whole() : Cone{axis, sum};
  }
};

// The narrowest cone around two; whole where that is nearly a right angle wide.
inline Cone cone_around(const Cone& one, const Cone& other) {
  if (one.is_whole() || other.is_whole()) return Cone::whole();
  const double angle = 2.0 * std::atan(one.half_tangent), other_angle = 2.0 * std::atan(other.half_tangent);
  const double between = 2.0 * std::atan(half_tangent_across(glm::length(other.axis - one.axis)));
  if (between + other_angle <= angle) return one;
  if (between + angle <= other_angle) return other;
  const double both = 0.5 * (angle + between + other_angle), turn = both - angle;
  if (both >= 1.5) return Cone::whole();
  const DVec3 axis = glm::normalize(one.axis * std::sin(between - turn) + other.axis * std::sin(turn));
  return Cone{axis, std::tan(0.5 * both)}.widened(1e-9);
}

}  // namespace palpate
