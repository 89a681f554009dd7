#include "samples/viewer/hand.h"

#include <algorithm>
#include <utility>

namespace palpate::viewer {
namespace {

constexpr double kLong = 600.0;  // s of a script; longer than anybody watches

}  // namespace

Hand::Hand(const Content& content, Rig& rig)
    : content_(content), rig_(rig), kind_(content.arguments.motion), held_(content.place.start) {
  if (content.arguments.replay) {
    follow(content.arguments.replay->poses());
  } else {
    begin(kind_);
  }
}

void Hand::before_step(std::uint64_t tick) {
  if (rig_.has_device()) return;
  const cli::Motion* replay = content_.arguments.replay.get();
  if (!replay) return rig_.place_tool(pose_of(wanted()));
  // A row a step, whatever its time, as `palpate run` does it.
  rig_.follow(*replay, std::min<std::size_t>(tick, replay->poses().size() - 1));
}

void Hand::move(const Vec3& by, const Vec3& turn, double seconds) {
  const Placement before = held_;
  held_.position += by;
  const double angle = glm::length(turn);
  if (angle > 0.0) {
    // About the model's middle, wherever its origin is.
    const Vec3 middle = held_ * content_.tool->centre();
    held_.orientation = glm::normalize(glm::angleAxis(angle, turn / angle) * held_.orientation);
    held_.position = middle - held_.orientation * content_.tool->centre();
  }
  if (rig_.has_simulated_hand()) return rig_.lead_hand(before, held_, std::max(seconds, 1e-3));
  if (!rig_.has_device()) rig_.place_tool(pose_of(held_));
}

void Hand::begin(MotionKind kind) {
  kind_ = kind;
  if (kind != MotionKind::kHold) return follow(sampled(kind, content_.place, kLong));
  held_ = rig_.tool();
  poses_.clear();
  if (rig_.has_simulated_hand()) rig_.lead_hand(held_, held_, 1.0);
}

Placement Hand::wanted() const {
  return scripted() ? at(poses_, poses_.front().seconds + rig_.seconds() - began_) : held_;
}

void Hand::follow(std::vector<cli::TimedPose> poses) {
  poses_ = std::move(poses);
  began_ = rig_.seconds();
  if (rig_.has_simulated_hand()) rig_.lead_hand(poses_);
}

}  // namespace palpate::viewer
