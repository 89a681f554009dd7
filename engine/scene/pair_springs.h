#pragma once

#include <span>
#include <vector>

#include "engine/math/pose.h"
#include "engine/scene/step_motion.h"
#include "engine/snch/lmd.h"

namespace palpate {

// A spring between a body and the tool. Metres, frame of the body.
struct PairSpring {
  Lmd at;
  DVec3 velocity{0.0};  // of the tool at point_b against the body, m/s
};

struct SpringSituation {
  Pose body_from_tool;
  double cutoff = 0.0;       // metres
  double time_step = 0.001;  // seconds since the last update
};

// What pushes between one body and the tool, from step to step: what a force law makes of a search, whichever
// law it is, and how each of it moves.
class PairSprings {
 public:
  void update(std::span<const Lmd> present, const SpringSituation& situation);

  // The pair is out of reach, or one of its models is another: the next update is as the first, without
  // motion.
  void forget() { known_ = false; }

  std::span<const PairSpring> list() const { return list_; }

 private:
  bool known_ = false;
  Pose last_pose_;
  std::vector<PairSpring> list_;
};

}  // namespace palpate
