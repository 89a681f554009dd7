#pragma once

#include "engine/math/vector.h"

namespace palpate {

// What a device's actuators are told to do to the hand: newtons and newton-metres in the device's base frame,
// about the origin of its tool frame (the centre of its gimbal).
struct DeviceWrench {
  DVec3 force{0.0};
  DVec3 torque{0.0};
};

}  // namespace palpate
