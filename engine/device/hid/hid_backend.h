#pragma once

#include "engine/device/device_backend.h"

namespace palpate {

// Opens devices on USB and Bluetooth that need no driver of their maker's: "hid:VENDOR:PRODUCT", in four hex
// digits each, or "hid:VENDOR:PRODUCT:SERIAL".
class HidBackend final : public DeviceBackend {
 public:
  std::string_view scheme() const override { return "hid"; }
  std::vector<DeviceInfo> enumerate() const override;
  Result<std::unique_ptr<Device>> open(std::string_view name) const override;
};

}  // namespace palpate
