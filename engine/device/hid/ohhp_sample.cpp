#include "engine/device/hid/ohhp_sample.h"

#include <cmath>

#include "engine/device/hid/little_endian.h"
#include "engine/device/hid/ohhp.h"

namespace palpate {
namespace {

constexpr double kPositionUnit = 1e-7;  // m
constexpr double kVelocityUnit = 1e-6;  // m/s, rad/s
constexpr double kQuaternionUnit = 1.0 / (1 << 30);
constexpr double kUnitSlack = 1e-3;

DVec3 vector_at(std::span<const std::uint8_t> report, std::size_t at, double unit) {
  return unit * DVec3(load_little<std::int32_t>(report, at), load_little<std::int32_t>(report, at + 4),
                      load_little<std::int32_t>(report, at + 8));
}

}  // namespace

std::optional<OhhpSample> parse_ohhp_sample(std::span<const std::uint8_t> report) {
  if (!ohhp::is_whole(report, ohhp::kSampleId, ohhp::kSampleSize)) return std::nullopt;
  OhhpSample sample;
  sample.flags = report[1];
  sample.sequence = load_little<std::uint16_t>(report, 2);
  sample.time_us = load_little<std::uint32_t>(report, 4);
  sample.tool.position = vector_at(report, 8, kPositionUnit);
  const DVec3 xyz = vector_at(report, 20, kQuaternionUnit);
  const DQuat turn(kQuaternionUnit * load_little<std::int32_t>(report, 32), xyz.x, xyz.y, xyz.z);
  if (std::abs(glm::length(turn) - 1.0) > kUnitSlack) return std::nullopt;
  sample.tool.orientation = glm::normalize(turn);
  sample.tool.linear_velocity = vector_at(report, 36, kVelocityUnit);
  sample.tool.angular_velocity = vector_at(report, 48, kVelocityUnit);
  sample.buttons = load_little<std::uint16_t>(report, 60);
  sample.temperature = report[62] / 255.0;
  return sample;
}

}  // namespace palpate
