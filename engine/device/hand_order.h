#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "engine/device/simulated/hand_impedance.h"
#include "engine/device/simulated/hand_motion.h"

namespace palpate {

// What a simulated hand is told; what is left out stays as it is.
struct HandOrder {
  std::optional<HandImpedance> impedance;
  std::shared_ptr<const HandMotion> motion;  // begins when the order is taken; null: goes on
  std::optional<std::uint32_t> buttons;
  bool place = false;  // the handle is moved, at once and at rest, to where the hand then intends to be
};

}  // namespace palpate
