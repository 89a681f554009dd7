#include "engine/device/simulated/encoder.h"

#include <cmath>
#include <glm/common.hpp>

#include "engine/device/rotation_vector.h"

namespace palpate {
namespace {

constexpr double kVelocityCorner = 100.0;  // Hz, of a first-order low pass
constexpr double kTurn = 6.283185307179586;

DVec3 in_counts(const DVec3& v, double count) {
  return count * glm::floor(v / count + 0.5);
}

}  // namespace

void Encoder::reset(const RigidMotion& motion) {
  last_ = {};
  last_ = quantised(motion);
}

RigidMotion Encoder::sample(const RigidMotion& motion, double dt) {
  RigidMotion now = quantised(motion);
  const double share = 1.0 - std::exp(-kTurn * kVelocityCorner * dt);
  const DVec3 velocity = (now.position - last_.position) / dt;
  const DVec3 turn_rate = rotation_between(last_.orientation, now.orientation) / dt;
  now.linear_velocity = glm::mix(last_.linear_velocity, velocity, share);
  now.angular_velocity = glm::mix(last_.angular_velocity, turn_rate, share);
  last_ = now;
  return now;
}

// Cartesian counts stand for those of the arm's joints. Turns are counted from the last reading, as
// incremental encoders do: three angles would have an orientation at which their noise is without bounds.
RigidMotion Encoder::quantised(const RigidMotion& motion) const {
  RigidMotion read;
  read.position = in_counts(motion.position, position_resolution_);
  const DVec3 turn = rotation_between(last_.orientation, motion.orientation);
  read.orientation = glm::normalize(rotation_by(in_counts(turn, angle_resolution_)) * last_.orientation);
  return read;
}

}  // namespace palpate
