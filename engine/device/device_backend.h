#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/device/device.h"

namespace palpate {

// A way to reach devices: a simulation, a vendor's library, a bus. It owns the URIs of one scheme.
class DeviceBackend {
 public:
  virtual ~DeviceBackend() = default;
  DeviceBackend(const DeviceBackend&) = delete;
  DeviceBackend& operator=(const DeviceBackend&) = delete;

  // What stands before the colon of its URIs.
  virtual std::string_view scheme() const = 0;

  // The devices that could be opened now, and those that could be if their advice were followed. What only an
  // open device tells is left at zero.
  virtual std::vector<DeviceInfo> enumerate() const = 0;

  // The device whose URI is "scheme:name"; a null pointer if there is none, an Error if it cannot be opened.
  // What stands behind a question mark in the name are the backend's own parameters.
  virtual Result<std::unique_ptr<Device>> open(std::string_view name) const = 0;

 protected:
  DeviceBackend() = default;
};

}  // namespace palpate
