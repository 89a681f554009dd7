#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/device/device_backend.h"

namespace palpate {

// Opened where a caller names no device: it is always there.
constexpr std::string_view kDefaultDeviceUri = "sim:premium6dof";

// All devices, by URI.
class DeviceRegistry {
 public:
  // With the backends that every build has.
  static DeviceRegistry standard();

  void add(std::unique_ptr<DeviceBackend> backend);

  // In the order in which the backends were added; those that cannot be opened, too, with advice.
  std::vector<DeviceInfo> enumerate() const;

  // The device that a URI names, or the default for an empty one. The error names what exists.
  Result<std::unique_ptr<Device>> open(std::string_view uri) const;

 private:
  const DeviceBackend* find(std::string_view scheme) const;
  Error unknown(std::string_view uri) const;

  std::vector<std::unique_ptr<DeviceBackend>> backends_;
};

}  // namespace palpate
