#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/math/vector.h"

namespace palpate {

// The unit directions within an angle of an axis. The angle is at most a right angle, or the cone is `whole`.
struct Cone {
  DVec3 axis{0.0, 0.0, 1.0};
  double cosine = -1.0;

  static Cone whole() { return {}; }
  bool is_whole() const { return cosine < 0.0; }
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
    double cosine = 1.0;
    DVec3 farthest = axis;
    for (const Vec3& direction : directions) {
      const double c = glm::dot(axis, DVec3(direction));
      if (c < cosine) cosine = c, farthest = DVec3(direction);
    }
    if (cosine > best.cosine && cosine > 0.0) best = {axis, cosine};
    axis += (farthest - axis) / (round + 1.0);
  }
  return best;
}

}  // namespace palpate
