#pragma once

#include <cstdint>

namespace palpate {

// How a hand is held to the handle.
enum class Grip : std::uint8_t { kReleased, kLight, kFirm };

// A hand as the handle feels it: its mass moves with the handle, a spring and a damper tie both to where the
// hand wants to be. All zero is no hand.
struct HandImpedance {
  double mass = 0.0;               // kg
  double damping = 0.0;            // N·s/m
  double stiffness = 0.0;          // N/m
  double inertia = 0.0;            // kg·m²
  double angular_damping = 0.0;    // N·m·s/rad
  double angular_stiffness = 0.0;  // N·m/rad
};

HandImpedance impedance_of(Grip grip);

}  // namespace palpate
