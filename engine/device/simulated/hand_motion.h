#pragma once

#include "engine/math/vector.h"

namespace palpate {

// Where a hand wants the handle to be, in the device's base frame.
struct HandPose {
  DVec3 position{0.0};
  DQuat orientation{1.0, 0.0, 0.0, 0.0};  // w first; unit length
};

// What a hand intends over time. Immutable, and `at` allocates nothing.
class HandMotion {
 public:
  virtual ~HandMotion() = default;
  HandMotion(const HandMotion&) = delete;
  HandMotion& operator=(const HandMotion&) = delete;

  // `time` in seconds since the motion began, at least 0. Continuous.
  virtual HandPose at(double time) const = 0;

 protected:
  HandMotion() = default;
};

}  // namespace palpate
