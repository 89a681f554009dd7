#pragma once

#include "engine/device/device_backend.h"

namespace palpate {

// Devices of the PHANToM family through OpenHaptics, whose library is opened when it is first asked for. A
// name is one that the device was given by its maker's setup program; "library=" behind names another
// library.
class OpenHapticsBackend final : public DeviceBackend {
 public:
  std::string_view scheme() const override { return "openhaptics"; }
  std::vector<DeviceInfo> enumerate() const override;
  Result<std::unique_ptr<Device>> open(std::string_view name) const override;
};

}  // namespace palpate
