#pragma once

#include <span>
#include <vector>

#include "engine/math/pose.h"
#include "engine/scene/overlap_wall.h"
#include "engine/scene/spring_fade.h"
#include "engine/scene/spring_match.h"
#include "engine/scene/step_motion.h"
#include "engine/snch/lmd.h"

namespace palpate {

// A spring between a body and the tool. Metres, frame of the body.
struct PairSpring {
  Lmd at;                // the weight is what is in force: with the share of what comes or goes
  DVec3 velocity;        // of the tool at point_b against the body, m/s
  bool is_held = false;  // a wall, or fading
};

struct SpringSituation {
  Pose body_from_tool;
  double cutoff = 0.0;       // metres
  double time_step = 0.001;  // seconds since the last update
  double fade_time = 0.0;    // seconds
  bool overlapping = false;
  bool may_lose = false;  // the LMDs are not the complete set
};

// What pushes between one body and the tool, from step to step: what a force law makes of a search, whichever
// law it is; walls where the models overlap; and what fades. Where the complete set is known and nothing
// overlaps or did just now, that is what the law makes and nothing else. Keeps its memory.
class PairSprings {
 public:
  // Makes room, so that updates with up to so many present springs allocate nothing.
  void reserve(std::size_t springs);

  // Makes room for an update with so many present springs. Returns how many it may list.
  std::size_t make_room(std::size_t present);

  // Moves to `larger`, which has room for all that this has; it gets the memory of this.
  void move_to(PairSprings& larger);

  void update(std::span<const Lmd> present, const SpringSituation& situation);

  // The pair is out of reach, or one of its models is another: the next update is as the first, without
  // motion.
  void forget();

  std::span<const PairSpring> list() const { return list_; }
  bool is_walled() const { return !walls_.list().empty(); }

 private:
  bool is_holding(const SpringSituation& situation) const;
  void hold(std::span<const Lmd> present, const SpringSituation& situation, const HoldingStep& step);
  void end_walls(std::span<const Lmd> present, const SpringSituation& situation, const HoldingStep& step);
  bool replaces_walls(std::span<const Lmd> present, const HoldingStep& step) const;
  void share_out(std::span<const Lmd> present, const HoldingStep& step);
  double share_of(std::span<const Lmd> set, std::size_t begin, const HoldingStep& step) const;
  void remember(std::span<const Lmd> present, const SpringSituation& situation);
  void make_list(const SpringSituation& situation);

  bool known_ = false;
  bool may_lose_ = false;
  bool changing_ = false;  // some present springs come in
  Pose pose_;
  StepMotion motion_;
  std::vector<HeldSpring> last_;  // the law's
  std::vector<double> shares_;    // of the present ones
  SpringMatch match_;
  OverlapWall walls_;
  SpringFade fade_;
  bool comes_in_ = false;  // what is new in this step
  std::vector<PairSpring> list_;
};

}  // namespace palpate
