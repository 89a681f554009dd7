#pragma once

#include <cstdint>
#include <limits>

#include "engine/scene/body_ids.h"
#include "engine/scene/sphere.h"

namespace palpate {

// How far the tool has come, so that a body that was found out of its reach need not be looked at again
// before the tool may have covered the distance.
class ToolReach {
 public:
  // To where the tool is now. False: what was far may be near, because the tool is another, or the cutoff.
  bool follow(BodyId tool, const Sphere& sphere, double cutoff) {
    const double moved = glm::length(sphere.centre - sphere_.centre);
    const bool same = tool == tool_ && cutoff == cutoff_ && sphere.radius == sphere_.radius && moved < kMost;
    way_ = same ? way_ + moved * (1.0 + kRounding) + kRounding * way_ : 0.0;
    tool_ = tool;
    sphere_ = sphere;
    cutoff_ = cutoff;
    return same;
  }

  double way() const { return way_; }  // rounded up

  // The way until which a body is out of reach; 0 if it is not. Where a distance is not a number nothing is
  // in reach, and nothing stays out of it.
  double far_until(const Sphere& body) const {
    const double apart = beyond_reach(body, sphere_, cutoff_);
    if (apart <= 0.0) return 0.0;
    return apart > 0.0 ? way_ + kKept * apart : std::numeric_limits<double>::min();
  }

 private:
  static constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
  static constexpr double kKept = 1.0 - 1e-6;  // covers the rounding of what was added up
  static constexpr double kMost = 1e100;

  BodyId tool_ = 0;
  Sphere sphere_;
  double cutoff_ = 0.0;
  double way_ = 0.0;
};

}  // namespace palpate
