#include "engine/device/device_condition.h"

namespace palpate {

std::string_view advice_on(DeviceCondition condition) {
  switch (condition) {
    case DeviceCondition::kReady:
      return "ready";
    case DeviceCondition::kNeedsCalibration:
      return "not calibrated: calibrate it as its maker says";
    case DeviceCondition::kWarmMotors:
      return "its motors are warm: let it rest until force comes back";
    case DeviceCondition::kExceededForce:
      return "it was told to push harder than it can: lower the stiffness; force comes back by itself";
    case DeviceCondition::kExceededVelocity:
      return "it was moved too fast: hold it still; force comes back by itself";
    case DeviceCondition::kLost:
      return "it does not answer: check its cable and power; it is taken up again by itself";
    case DeviceCondition::kFailed:
      return "its driver reports an error";
    case DeviceCondition::kNoLibrary:
      return "the library that reaches it is not installed";
    case DeviceCondition::kWrongLibrary:
      return "the library that reaches it lacks a part: install the right version";
    case DeviceCondition::kCannotOpen:
      return "it cannot be opened";
    case DeviceCondition::kWithheld:
      return "it cannot be opened this way";
  }
  return "";
}

}  // namespace palpate
