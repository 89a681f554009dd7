#pragma once

#include "engine/math/pose.h"

namespace palpate {

// How the tool has moved against a body in one step, in the body's frame. What has not moved, moves by
// exactly zero.
class StepMotion {
 public:
  StepMotion() = default;  // none
  StepMotion(const Pose& before, const Pose& now) {
    moved_ = before.rotation != now.rotation || before.translation != now.translation;
    if (moved_) before_from_now_ = before * inverse(now);
  }

  // Of the tool's material point that is at `point` now.
  DVec3 at(const DVec3& point) const { return moved_ ? point - before_from_now_ * point : DVec3(0.0); }

 private:
  bool moved_ = false;
  Pose before_from_now_;
};

}  // namespace palpate
