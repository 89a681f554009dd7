#pragma once

#include <limits>

#include "engine/math/vector.h"

namespace palpate {

// An axis-aligned box; empty until it is grown.
struct Box {
  DVec3 low{std::numeric_limits<double>::infinity()};
  DVec3 high{-std::numeric_limits<double>::infinity()};

  void grow(const DVec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  bool empty() const { return !(low.x <= high.x); }
  DVec3 centre() const { return 0.5 * (low + high); }
  DVec3 size() const { return high - low; }
  double diagonal() const { return empty() ? 0.0 : glm::length(size()); }
};

}  // namespace palpate
