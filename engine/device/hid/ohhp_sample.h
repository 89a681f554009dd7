#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/device/rigid_motion.h"

namespace palpate {

// What an OHHP device says a thousand times a second.
struct OhhpSample {
  enum Flag : std::uint8_t {
    kCalibrated = 1 << 0,
    kArmed = 1 << 1,      // its amplifiers are on
    kDeadMan = 1 << 2,    // held, or there is none
    kWatchdog = 1 << 3,   // no wrench came in time: it has let go
    kTooHot = 1 << 4,     // no force until it has cooled down
    kSaturated = 1 << 5,  // it gave less than it was told to
    kEmergency = 1 << 6,  // its emergency stop is pressed
  };

  std::uint8_t flags = 0;
  std::uint16_t sequence = 0;  // wraps
  std::uint32_t time_us = 0;   // wraps
  RigidMotion tool;
  std::uint16_t buttons = 0;
  double temperature = 0.0;  // 0, cold, to 1, too hot

  bool has(Flag flag) const { return (flags & flag) != 0; }
};

// None if the report is of another kind or length, damaged, or holds an orientation that is none.
std::optional<OhhpSample> parse_ohhp_sample(std::span<const std::uint8_t> report);

}  // namespace palpate
