#pragma once

#include <span>

#include "engine/mesh/triangle_soup.h"
#include "tests/support/random_poses.h"

namespace palpate::stress {

// Two models near each other.
struct Case {
  TriangleSoup a;
  TriangleSoup b;
  Pose a_from_b;
  double cutoff;       // metres
  double step = 1e-3;  // metres, of a motion that ends at the pose
};

// A way in which numbers fail, and cases of it without end.
struct Family {
  const char* name;
  Case (*make)(Random& random);
};

std::span<const Family> families();

}  // namespace palpate::stress
