#include "engine/device/simulated/scripted_motion.h"

#include <algorithm>
#include <cmath>

#include "engine/device/rotation_vector.h"

namespace palpate {
namespace {

constexpr double kTurn = 6.283185307179586;

// 0 to 1 over the first period, starting and ending at rest.
double eased(double turns) {
  const double t = std::clamp(turns, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// 0 to 1 and back over each period.
double there_and_back(double turns) {
  return 0.5 - 0.5 * std::cos(kTurn * turns);
}

}  // namespace

HandPose ScriptedMotion::at(double time) const {
  const double turns = time / parameters_.period;
  HandPose pose = parameters_.origin;
  if (script_ == HandScript::kHold) return pose;
  pose.position += depth_at(turns) * parameters_.into + travel_at(turns) * parameters_.along;
  const double twist = parameters_.twist * eased(turns) * std::sin(kTurn * turns);
  pose.orientation = rotation_by(twist * parameters_.into) * pose.orientation;
  return pose;
}

double ScriptedMotion::depth_at(double turns) const {
  switch (script_) {
    case HandScript::kHold:
      return 0.0;
    case HandScript::kTap:
      return parameters_.depth * there_and_back(turns);
    case HandScript::kCircle:
      return parameters_.travel * eased(turns) * std::sin(kTurn * turns);
    case HandScript::kPress:
    case HandScript::kSlide:
    case HandScript::kWedge:
      return parameters_.depth * eased(turns);
  }
  return 0.0;
}

double ScriptedMotion::travel_at(double turns) const {
  switch (script_) {
    case HandScript::kHold:
    case HandScript::kTap:
    case HandScript::kPress:
      return 0.0;
    case HandScript::kSlide:
      return parameters_.travel * there_and_back(std::max(0.0, turns - 1.0));
    case HandScript::kWedge:
      return parameters_.travel * eased(turns) * std::sin(kTurn * turns);
    case HandScript::kCircle:
      return parameters_.travel * eased(turns) * std::cos(kTurn * turns);
  }
  return 0.0;
}

}  // namespace palpate
