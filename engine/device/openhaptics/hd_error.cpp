#include "engine/device/openhaptics/hd_error.h"

#include <cstdio>

namespace palpate {
namespace {

const char* advice_on_opening(hd::ErrorCode code) {
  switch (code) {
    case hd::kAlreadyOpen:
      return "it is open already, here or in another program";
    case hd::kCommunicationSetup:
      return "pair it by its maker's setup program first";
    case hd::kLicence:
      return "install the licence of OpenHaptics";
    default:
      return "check its cable, its power, that its maker's setup program finds it under this name, and that "
             "you "
             "may use its port, such as /dev/ttyACM0";
  }
}

}  // namespace

DeviceCondition condition_of(hd::ErrorCode code) {
  switch (code) {
    case hd::kWarmMotors:
      return DeviceCondition::kWarmMotors;
    case hd::kExceededForce:
    case hd::kExceededImpulse:
    case hd::kForceError:
      return DeviceCondition::kExceededForce;
    case hd::kExceededVelocity:
      return DeviceCondition::kExceededVelocity;
    case hd::kDeviceFault:
    case hd::kCommunication:
    case hd::kCommunicationSetup:
    case hd::kTimer:
      return DeviceCondition::kLost;
    default:
      return DeviceCondition::kFailed;
  }
}

Error opening_error(const hd::Functions& call, const std::string& device, const hd::ErrorInfo& info) {
  char numbers[64];
  std::snprintf(numbers, sizeof numbers, "error 0x%04x, internal %d", info.code, info.internal);
  const char* const text = call.hdGetErrorString(info.code);
  return {ErrorCode::kDevice, "\"openhaptics:" + device + "\" cannot be opened: " + (text ? text : "?") +
                                  " (" + numbers + "); " + advice_on_opening(info.code)};
}

hd::ErrorInfo clear_errors(const hd::Functions& call) {
  const hd::ErrorInfo first = call.hdGetError();
  if (first.code == 0) return first;
  for (int i = 1; i < kMostErrors && call.hdGetError().code != 0; ++i) {
  }
  return first;
}

}  // namespace palpate
