#include "engine/device/hid/ohhp_wrench.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "engine/device/hid/little_endian.h"

namespace palpate {
namespace {

// Rounded and saturated; what is no number is none.
template <class Integer>
Integer in_units(double value, double units) {
  constexpr double kLeast = std::numeric_limits<Integer>::min();
  constexpr double kMost = std::numeric_limits<Integer>::max();
  if (std::isnan(value)) return 0;
  return static_cast<Integer>(std::clamp(std::round(value * units), kLeast, kMost));
}

void store_vector(const DVec3& v, std::span<std::uint8_t> report, std::size_t at) {
  constexpr double kMicro = 1e6;
  for (int axis = 0; axis < 3; ++axis) {
    store_little(in_units<std::int32_t>(v[axis], kMicro), report, at + 4 * static_cast<std::size_t>(axis));
  }
}

}  // namespace

std::array<std::uint8_t, ohhp::kWrenchSize> ohhp_report(const OhhpWrench& wrench) {
  std::array<std::uint8_t, ohhp::kWrenchSize> report{};
  report[0] = ohhp::kWrenchId;
  store_little(wrench.answered, report, 2);
  store_vector(wrench.wrench.force, report, 4);
  store_vector(wrench.wrench.torque, report, 16);
  store_little(in_units<std::uint16_t>(wrench.time_to_live, 1e3), report, 28);
  ohhp::seal(report);
  return report;
}

std::array<std::uint8_t, ohhp::kCommandSize> ohhp_report(const OhhpCommand& command) {
  std::array<std::uint8_t, ohhp::kCommandSize> report{};
  report[0] = ohhp::kCommandId;
  report[1] = static_cast<std::uint8_t>(command.kind);
  store_little(command.milliseconds, report, 2);
  ohhp::seal(report);
  return report;
}

}  // namespace palpate
