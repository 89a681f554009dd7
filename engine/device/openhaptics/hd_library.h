#pragma once

#include <string>
#include <string_view>

#include "engine/device/device_condition.h"
#include "engine/device/openhaptics/hd_abi.h"

namespace palpate {

class HdScheduler;

// The vendor's library, which is opened while the program runs and never closed: it does not bear a second
// opening.
struct HdLibrary {
  HdScheduler* scheduler = nullptr;  // null: the library cannot be used, for the reason below
  DeviceCondition condition = DeviceCondition::kReady;
  std::string advice;

  // The library at `path`, or if that is empty at the path that the environment names, or if there is none
  // under one of the names that its versions have. What has failed is tried again.
  static HdLibrary open(std::string_view path);
};

}  // namespace palpate
