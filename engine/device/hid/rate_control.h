#pragma once

#include <array>

#include "engine/device/rigid_motion.h"
#include "engine/math/box.h"

namespace palpate {

// How fast a cap at full deflection moves a tool, and what it takes to move it at all.
struct RateGains {
  double speed = 0.15;      // m/s
  double turn_rate = 1.5;   // rad/s
  double dead_zone = 0.06;  // of full deflection, for each axis: a cap that is let go rests within it
};

// A pose that is moved at the rate at which a cap is pushed: velocity, not place. It stays in a box. Position
// and velocity in the base frame; the pose turns about its own origin, about the base frame's axes.
class RateControl {
 public:
  RateControl(const RateGains& gains, const Box& reach) : gains_(gains), reach_(reach) {}

  // The deflection of the cap from now on, -1 to 1 along and about +x, +y, +z.
  void push(const std::array<double, 6>& deflection);

  void step(double dt);

  const RigidMotion& motion() const { return motion_; }

 private:
  double rate(double deflection) const;

  RateGains gains_;
  Box reach_;
  DVec3 speed_{0.0};  // as wanted; the motion's own is zero at the end of the reach
  DVec3 turn_rate_{0.0};
  RigidMotion motion_;
};

}  // namespace palpate
