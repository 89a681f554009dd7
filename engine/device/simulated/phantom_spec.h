#pragma once

#include <span>
#include <string_view>

#include "engine/device/device_info.h"
#include "engine/device/simulated/handle_body.h"

namespace palpate {

// A model of PHANToM as it is simulated.
struct PhantomSpec {
  std::string_view uri_name;  // behind "sim:"
  std::string_view name;
  DeviceCapabilities capabilities;
  DeviceLimits limits;
  HandleProperties handle;
};

// PHANToM Premium 1.5/6DOF: six degrees sensed and actuated.
const PhantomSpec& premium6dof_spec();

// Touch: six degrees sensed, no torque.
const PhantomSpec& touch_spec();

// What a device of this model says of itself.
DeviceInfo info_of(const PhantomSpec& spec);

// Every model, the default first.
std::span<const PhantomSpec> phantom_specs();

}  // namespace palpate
