#pragma once

#include <vector>

#include "tests/support/random_poses.h"

namespace palpate {

// A hand that slides `b` over `a` without crossing it: `speed` metres a second, a pose a millisecond, the gap
// swinging between 5 and 70 % of the cutoff.
std::vector<Pose> sliding_motion(const Model& a, const Model& b, double cutoff, double speed, int ticks,
                                 Random& random);

}  // namespace palpate
