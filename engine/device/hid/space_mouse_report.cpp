#include "engine/device/hid/space_mouse_report.h"

#include <algorithm>
#include <cstddef>

#include "engine/device/hid/little_endian.h"

namespace palpate {
namespace {

constexpr std::uint8_t kMotionId = 1;  // or, with six numbers, motion and turn
constexpr std::uint8_t kTurnId = 2;
constexpr std::uint8_t kButtonsId = 3;

constexpr std::size_t kThreeAxes = 1 + 3 * 2;
constexpr std::size_t kSixAxes = 1 + 6 * 2;

}  // namespace

bool SpaceMouseReport::take(std::span<const std::uint8_t> report) {
  if (report.size() < 2) return false;
  if (report[0] == kButtonsId) {
    buttons = 0;
    const std::size_t bytes = std::min<std::size_t>(report.size() - 1, sizeof buttons);
    for (std::size_t i = 0; i < bytes; ++i) buttons |= std::uint32_t{report[1 + i]} << (8 * i);
    return true;
  }
  if (report[0] != kMotionId && report[0] != kTurnId) return false;
  if (report.size() < kThreeAxes) return false;
  const std::size_t count = report[0] == kMotionId && report.size() >= kSixAxes ? 6 : 3;
  const std::size_t first = report[0] == kTurnId ? 3 : 0;
  for (std::size_t i = 0; i < count; ++i) {
    const int value = load_little<std::int16_t>(report, 1 + 2 * i);
    axes[first + i] = std::clamp(value, -kFullDeflection, kFullDeflection);
  }
  return true;
}

}  // namespace palpate
