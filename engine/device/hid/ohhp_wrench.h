#pragma once

#include <array>
#include <cstdint>

#include "engine/device/device_wrench.h"
#include "engine/device/hid/ohhp.h"

namespace palpate {

// What an OHHP device is told to push with. It lives from the time of the sample that it answers, so one that
// was held up on its way is dead when it arrives.
struct OhhpWrench {
  DeviceWrench wrench;         // finite
  std::uint16_t answered = 0;  // sequence of the sample it was computed from
  double time_to_live = 0.0;   // s
};

std::array<std::uint8_t, ohhp::kWrenchSize> ohhp_report(const OhhpWrench& wrench);

// What it is told to do, by feature report 4.
struct OhhpCommand {
  enum class Kind : std::uint8_t { kArm = 1, kDisarm = 2, kCalibrate = 3, kSetWatchdog = 4 };

  Kind kind = Kind::kDisarm;
  std::uint16_t milliseconds = 0;  // kSetWatchdog's
};

std::array<std::uint8_t, ohhp::kCommandSize> ohhp_report(const OhhpCommand& command);

}  // namespace palpate
