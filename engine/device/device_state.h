#pragma once

#include <cstdint>

#include "engine/device/device_condition.h"
#include "engine/device/rigid_motion.h"

namespace palpate {

// One sample of a device's sensors.
struct DeviceState {
  RigidMotion tool;
  double time = 0.0;           // seconds, of the sample, by the device's own clock
  std::uint64_t sequence = 0;  // grows with every sample: equal means nothing new was measured
  std::uint32_t buttons = 0;   // bit i is set while button i is held
  bool calibrated = false;     // a pose that is not calibrated must not be turned into force
  DeviceCondition condition = DeviceCondition::kReady;
  double temperature = 0.0;  // of the hottest motor, from 0, cold, to 1, too hot; 0 where none is measured
  bool held = true;          // false: it has a dead-man switch of its own, and that is let go
  std::uint64_t lost = 0;    // samples that were taken but never arrived, since it was opened
};

}  // namespace palpate
