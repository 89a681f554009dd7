#include "engine/scene/pair_springs.h"

namespace palpate {
namespace {

// A hand does not go farther than the cutoff in one step: then it was put there, and has no velocity.
DVec3 velocity_at(const DVec3& point, const StepMotion& motion, const SpringSituation& situation) {
  const DVec3 moved = motion.at(point);
  if (!(glm::length(moved) <= situation.cutoff)) return DVec3(0.0);
  return moved / situation.time_step;
}

}  // namespace

void PairSprings::update(std::span<const Lmd> present, const SpringSituation& situation) {
  const StepMotion motion = known_ ? StepMotion(last_pose_, situation.body_from_tool) : StepMotion();
  list_.clear();
  for (const Lmd& spring : present) list_.push_back({spring, velocity_at(spring.point_b, motion, situation)});
  last_pose_ = situation.body_from_tool;
  known_ = true;
}

}  // namespace palpate
