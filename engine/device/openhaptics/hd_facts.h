#pragma once

#include <string>

#include "engine/device/device_info.h"
#include "engine/device/openhaptics/hd_abi.h"

namespace palpate {

// What an open device tells of itself before it moves.
struct HdFacts {
  DeviceInfo info;  // limits are the device's or ours for its model, whichever are tighter
  int calibration_styles = 0;
  int plain_buttons = 0;  // behind them: held while the stylus is out of its inkwell, where there is one
  bool has_inkwell = false;
  bool has_temperatures = false;
};

// Asks the current device, without a frame.
HdFacts read_facts(const hd::Functions& call, const std::string& uri);

}  // namespace palpate
