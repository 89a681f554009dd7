#include "engine/device/hid/hid_backend.h"

namespace palpate {
namespace {

constexpr const char* kAdvice =
    "this build of Palpate has no hidapi: install libhidapi-dev, configure it anew and build it";

}  // namespace

std::vector<DeviceInfo> HidBackend::enumerate() const {
  DeviceInfo info;
  info.identity = {"hid:", "SpaceMouse and open haptic devices", ""};
  info.condition = DeviceCondition::kNoLibrary;
  info.advice = kAdvice;
  return {info};
}

Result<std::unique_ptr<Device>> HidBackend::open(std::string_view name) const {
  return Error{ErrorCode::kDevice, "hid:" + std::string(name) + ": " + kAdvice};
}

}  // namespace palpate
