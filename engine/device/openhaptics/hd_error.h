#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/device/device_condition.h"
#include "engine/device/openhaptics/hd_abi.h"

namespace palpate {

// What an error in a tick means for the device.
DeviceCondition condition_of(hd::ErrorCode code);

// Why a device cannot be opened, and what to do about it.
Error opening_error(const hd::Functions& call, const std::string& device, const hd::ErrorInfo& info);

// Takes every error from the library's stack; the first one that is found, or one with code 0.
hd::ErrorInfo clear_errors(const hd::Functions& call);

// Errors that a library keeps at most; so that one that always has another does not hold up a tick.
constexpr int kMostErrors = 32;

}  // namespace palpate
