#pragma once

#include "engine/device/rigid_motion.h"

namespace palpate {

// What a device reports of its handle's motion: positions in whole counts, orientations that turn by whole
// counts, and velocities that are differences of these, smoothed as drivers do.
class Encoder {
 public:
  // Metres and radians per count.
  Encoder(double position_resolution, double angle_resolution)
      : position_resolution_(position_resolution), angle_resolution_(angle_resolution) {}

  // Forgets what was sampled: the next motion starts at rest.
  void reset(const RigidMotion& motion);

  // The reading `dt` seconds after the one before.
  RigidMotion sample(const RigidMotion& motion, double dt);

  const RigidMotion& last() const { return last_; }

 private:
  RigidMotion quantised(const RigidMotion& motion) const;

  double position_resolution_;
  double angle_resolution_;
  RigidMotion last_;
};

}  // namespace palpate
