#pragma once

#include <string>
#include <vector>

#include "palpate/palpate.h"

namespace palpate::cli {

// One row of a trajectory: where a model is at a time.
struct TimedPose {
  double seconds;
  plp_pose pose;
};

// Reads a CSV file with the header t,px,py,pz,qx,qy,qz,qw. Throws Failure that names the file and line.
std::vector<TimedPose> read_trajectory(const std::string& path);

}  // namespace palpate::cli
