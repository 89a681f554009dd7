#pragma once

#include "engine/device/device_backend.h"

namespace palpate {

// Opens the simulated devices, any number of each. A name may end in "?delay=N": samples, 0 to 8, that its
// sensors are late.
class SimulatedBackend final : public DeviceBackend {
 public:
  std::string_view scheme() const override { return "sim"; }
  std::vector<DeviceInfo> enumerate() const override;
  Result<std::unique_ptr<Device>> open(std::string_view name) const override;
};

}  // namespace palpate
