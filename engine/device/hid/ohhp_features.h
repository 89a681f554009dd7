#pragma once

#include <cstdint>
#include <span>

#include "engine/base/result.h"
#include "engine/device/device_info.h"

namespace palpate {

// What an OHHP device is and can do.
struct OhhpFeatures {
  enum Trait : std::uint8_t {
    kHasDeadMan = 1 << 0,
    kWantsCalibration = 1 << 1,  // somebody must tell it when its handle is in place
  };

  std::uint8_t traits = 0;
  DeviceCapabilities capabilities;
  DeviceLimits limits;
  double watchdog = 0.0;  // s without a wrench after which it lets go

  bool has(Trait trait) const { return (traits & trait) != 0; }
};

// Limits are lowered to what any device of this kind may have; a degree that is not actuated gets none. The
// error tells what is wrong with the report, without naming the device.
Result<OhhpFeatures> parse_ohhp_features(std::span<const std::uint8_t> report);

}  // namespace palpate
