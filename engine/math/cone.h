#pragma once

#include <algorithm>
#include <cmath>
#include <span>

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

// A narrow cone around unit directions: centred on their mean, then pulled towards the farthest one for a few
// rounds (Bădoiu & Clarkson 2003). Whole where they do not fit into a half-space.
inline Cone cone_around(std::span<const Vec3> directions) {
  constexpr int kRounds = 4;
  DVec3 axis(0.0);
  for (const Vec3& direction : directions) axis += DVec3(direction);
  Cone best;
  for (int round = 1; round <= kRounds + 1; ++round) {
    const double length = glm::length(axis);
    if (!(length > 1e-9)) break;
    axis /= length;
    double most = 0.0;
    DVec3 farthest = axis;
    for (const Vec3& direction : directions) {
      const DVec3 chord = DVec3(direction) - axis;
      const double squared = glm::dot(chord, chord);
      if (squared > most) most = squared, farthest = DVec3(direction);
    }
    const double half_tangent = half_tangent_across(std::sqrt(most));
    if (half_tangent < std::min(best.half_tangent, 1.0)) best = {axis, half_tangent};
    axis += (farthest - axis) / (round + 1.0);
  }
  return best;
}

}  // namespace palpate
