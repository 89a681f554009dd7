#pragma once

#include <cstdint>

#include "engine/device/device_state.h"
#include "engine/device/device_wrench.h"
#include "engine/device/safety_report.h"

namespace palpate {

// All that there is to know of a device after a tick.
struct DeviceStatus {
  DeviceState state;        // the sample that the tick began with
  DeviceWrench wanted;      // by whoever computes
  DeviceWrench applied;     // what the safety limits made of it
  bool unactuated = false;  // part of what was wanted was dropped: the device has no motors for it
  SafetyReport safety;
  std::uint64_t ticks = 0;
};

}  // namespace palpate
