#pragma once

#include "engine/device/device_backend.h"

namespace palpate {

// Opens the simulated devices, any number of each.
class SimulatedBackend final : public DeviceBackend {
 public:
  std::string_view scheme() const override { return "sim"; }
  std::vector<DeviceIdentity> enumerate() const override;
  Result<std::unique_ptr<Device>> open(std::string_view name) const override;
};

}  // namespace palpate
