#pragma once

#include <cstdint>

#include "engine/device/simulated/hand_motion.h"

namespace palpate {

// What a scripted hand does.
enum class HandScript : std::uint8_t {
  kHold,   // stays at the origin
  kTap,    // in by the depth and out again, for ever
  kPress,  // in by the depth, and stays there
  kSlide,  // presses, then to and fro along the travel
  kWedge,  // presses in by the depth while it sways to both sides
  kCircle  // around the origin in the plane of both directions, without depth
};

struct ScriptParameters {
  HandPose origin;             // at time 0
  DVec3 into{0.0, -1.0, 0.0};  // unit vector, into the surface
  DVec3 along{1.0, 0.0, 0.0};  // unit vector, across `into`
  double depth = 0.01;         // m along `into`
  double travel = 0.02;        // m along `along`: stroke of a slide, half of a sway, radius of a circle
  double twist = 0.0;          // rad about `into`, to both sides, with the same period
  double period = 1.0;         // s of one tap, stroke, sway or turn, and of the first press
};

// A motion made of a formula.
class ScriptedMotion final : public HandMotion {
 public:
  ScriptedMotion(HandScript script, const ScriptParameters& parameters)
      : script_(script), parameters_(parameters) {}

  HandPose at(double time) const override;

 private:
  double depth_at(double turns) const;
  double travel_at(double turns) const;

  HandScript script_;
  ScriptParameters parameters_;
};

}  // namespace palpate
