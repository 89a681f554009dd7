#pragma once

#include <functional>
#include <vector>

#include "engine/scene/query.h"
#include "tests/support/random_poses.h"

namespace palpate {

// A motion over a time from 0 to 1.
using Motion = std::function<Pose(double)>;

// The wrenches about B's centre of unit springs under a law, relative to what one spring can push: forces in
// k·c, torques in k·c times B's radius.
std::vector<Wrench> wrenches_along(const Model& a, const Model& b, const Motion& motion, int steps,
                                   double cutoff, ForceLaw law);

// The largest change of force, or of torque, from one to the `stride`-th next.
double largest_step(const std::vector<Wrench>& wrenches, std::size_t stride);

// What is left of a change of the wrench between two times of a motion in the ever smaller half with the
// larger change: nothing unless it is a jump.
double jump_between(const Model& a, const Model& b, const Motion& motion, double from, double to,
                    double cutoff, ForceLaw law);

// The largest difference between two runs.
double largest_difference(const std::vector<Wrench>& one, const std::vector<Wrench>& other);

// B drifts and turns near A, by about `way` (metres), never nearer than a tenth of the cutoff.
Motion drift(const Model& a, const Model& b, double cutoff, double way, Random& random);

}  // namespace palpate
