#pragma once

#include <limits>

#include "engine/math/pose.h"

namespace palpate {

// A bounding sphere, metres.
struct Sphere {
  DVec3 centre{0.0};
  double radius = 0.0;
};

inline Sphere operator*(const Pose& pose, const Sphere& sphere) {
  return {pose * sphere.centre, sphere.radius};
}

// How much farther apart the two are than `cutoff`, at least: far from the origin, too, where the centres are
// rounded.
inline double beyond_reach(const Sphere& a, const Sphere& b, double cutoff) {
  const double reach = a.radius + b.radius + cutoff;
  const double rounding =
      8.0 * std::numeric_limits<double>::epsilon() * (glm::length(a.centre) + glm::length(b.centre) + reach);
  return glm::length(b.centre - a.centre) - (reach + rounding);
}

// Whether what is inside the two may be within `cutoff` of each other. False when a distance is not a number.
inline bool within_reach(const Sphere& a, const Sphere& b, double cutoff) {
  return beyond_reach(a, b, cutoff) <= 0.0;
}

}  // namespace palpate
