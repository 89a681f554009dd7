#pragma once

#include <cstdint>
#include <string_view>

namespace palpate {

// What a device, or the way to it, says of itself.
enum class DeviceCondition : std::uint8_t {
  kReady,
  kNeedsCalibration,  // its pose is not to be trusted yet
  kWarmMotors,        // no force until they have cooled down
  kExceededForce,     // it was told to push harder than it can, and has let go for a while
  kExceededVelocity,  // it was moved faster than it follows, and has let go for a while
  kLost,              // it does not answer; once it does, it is taken up again
  kFailed,            // its driver reports another error
  kNoLibrary,         // listed only, as the next three: what reaches it is not installed
  kWrongLibrary,      // what is installed lacks a part
  kCannotOpen,
  kWithheld,  // another way to it is the right one, or the system does not permit this one
};

// Whether it can give no force by a fault of its own. One that is not calibrated has none.
constexpr bool is_fault(DeviceCondition condition) {
  return condition > DeviceCondition::kNeedsCalibration;
}

// Whether it may be opened.
constexpr bool is_openable(DeviceCondition condition) {
  return condition < DeviceCondition::kNoLibrary;
}

// What its user can do about it, in one sentence.
std::string_view advice_on(DeviceCondition condition);

}  // namespace palpate
