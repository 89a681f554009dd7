#pragma once

#include "engine/math/vector.h"

namespace palpate {

// Where a tool is and how it moves, in its device's base frame: +x right, +y up, +z towards the user.
struct RigidMotion {
  DVec3 position{0.0};
  DQuat orientation{1.0, 0.0, 0.0, 0.0};  // w first; base frame from tool frame, unit length
  DVec3 linear_velocity{0.0};             // m/s
  DVec3 angular_velocity{0.0};            // rad/s
};

}  // namespace palpate
