#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace palpate {

// What a SpaceMouse's cap and buttons were last reported to be. Six axes as the device counts them: along and
// about its own x (right), y (towards the user) and z (down).
struct SpaceMouseReport {
  static constexpr int kFullDeflection = 350;

  std::array<int, 6> axes{};
  std::uint32_t buttons = 0;

  // Takes what a report tells. Older devices report translation and rotation apart, newer ones together; the
  // length tells which. False, and nothing changes, for any other report.
  bool take(std::span<const std::uint8_t> report);
};

}  // namespace palpate
