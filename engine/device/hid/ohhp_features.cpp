#include "engine/device/hid/ohhp_features.h"

#include <algorithm>
#include <string>

#include "engine/device/hid/little_endian.h"
#include "engine/device/hid/ohhp.h"

namespace palpate {
namespace {

// Beyond these a number is a mistake in somebody's firmware, and dangerous.
constexpr double kMostForce = 50.0;       // N
constexpr double kMostTorque = 2.0;       // N·m
constexpr double kMostStiffness = 1e5;    // N/m
constexpr double kMostDamping = 1e3;      // N·s/m
constexpr double kMostRate = 20'000.0;    // Hz
constexpr double kLeastRate = 200.0;      // Hz: a slower device's poses are stale before the next comes
constexpr double kLongestWatchdog = 0.1;  // s
constexpr int kMostButtons = 16;

constexpr double kMilli = 1e-3;
constexpr double kMicro = 1e-6;
constexpr double kNano = 1e-9;

double number_at(std::span<const std::uint8_t> report, std::size_t at, double unit, double most) {
  return std::min(unit * load_little<std::uint32_t>(report, at), most);
}

DVec3 corner_at(std::span<const std::uint8_t> report, std::size_t at) {
  return kMilli * DVec3(load_little<std::int16_t>(report, at), load_little<std::int16_t>(report, at + 2),
                        load_little<std::int16_t>(report, at + 4));
}

DeviceLimits limits_in(std::span<const std::uint8_t> report, DegreesOfFreedom actuated) {
  DeviceLimits limits;
  if (actuated & kTranslations) {
    limits.max_force = number_at(report, 16, kMilli, kMostForce);
    limits.continuous_force = number_at(report, 20, kMilli, limits.max_force);
    limits.max_stiffness = number_at(report, 32, 1.0, kMostStiffness);
    limits.max_damping = number_at(report, 36, kMilli, kMostDamping);
  }
  if (actuated & kRotations) {
    limits.max_torque = number_at(report, 24, kMicro, kMostTorque);
    limits.continuous_torque = number_at(report, 28, kMicro, limits.max_torque);
  }
  limits.position_resolution = number_at(report, 40, kNano, 1.0);
  limits.angle_resolution = number_at(report, 44, kMicro, 1.0);
  limits.update_rate = std::min<double>(load_little<std::uint16_t>(report, 10), kMostRate);
  limits.workspace = {corner_at(report, 48), corner_at(report, 54)};
  return limits;
}

Error wrong(const std::string& what) {
  return {ErrorCode::kDevice, "its feature report 3 " + what};
}

}  // namespace

Result<OhhpFeatures> parse_ohhp_features(std::span<const std::uint8_t> report) {
  constexpr std::string_view kMagic = "OHHP";
  if (report.size() != ohhp::kFeaturesSize || report[0] != ohhp::kFeaturesId) {
    return wrong("has " + std::to_string(report.size()) + " bytes, not 64");
  }
  if (!std::equal(kMagic.begin(), kMagic.end(), report.begin() + 1)) return wrong("does not begin with OHHP");
  if (!ohhp::is_whole(report, ohhp::kFeaturesId, ohhp::kFeaturesSize)) return wrong("has a wrong checksum");
  if (report[5] != ohhp::kVersion) {
    return wrong("is of version " + std::to_string(report[5]) + ", and this is version 1");
  }
  OhhpFeatures features;
  features.capabilities.sensed = report[6] & kAllDegrees;
  features.capabilities.actuated = report[7] & kAllDegrees;
  features.capabilities.buttons = std::min<int>(report[9], kMostButtons);
  features.traits = report[8];
  features.limits = limits_in(report, features.capabilities.actuated);
  features.watchdog = std::min(kMilli * load_little<std::uint16_t>(report, 12), kLongestWatchdog);
  if (features.limits.update_rate < kLeastRate) return wrong("tells of fewer than 200 samples a second");
  if (features.watchdog == 0.0) return wrong("tells of no watchdog, without which a device is not safe");
  return features;
}

}  // namespace palpate
