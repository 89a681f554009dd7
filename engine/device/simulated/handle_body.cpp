#include "engine/device/simulated/handle_body.h"

#include <cmath>

#include "engine/device/rotation_vector.h"

namespace palpate {
namespace {

constexpr double kLongestSubStep = 10e-6;  // s

// A mechanical stop: 1 mm of give at ten newtons.
constexpr double kStopStiffness = 1e4;  // N/m
constexpr double kStopDamping = 20.0;   // N·s/m

// What Coulomb friction leaves of a velocity that it can change by `most`: it stops, but never turns round.
DVec3 after_friction(const DVec3& velocity, double most) {
  const double speed = glm::length(velocity);
  return speed <= most ? DVec3(0.0) : velocity * (1.0 - most / speed);
}

}  // namespace

void HandleBody::step(const DeviceWrench& wrench, const HandImpedance& hand, RigidMotion target, double dt) {
  // A tick that is a whole number of sub-steps but for rounding gets no extra one.
  constexpr double kRounding = 1e-9;
  const int count = static_cast<int>(std::ceil(dt / kLongestSubStep - kRounding));
  const double h = dt / count;
  for (int i = 0; i < count; ++i) {
    target.position += h * target.linear_velocity;
    target.orientation = slightly_turned(target.orientation, h * target.angular_velocity);
    step_translation(wrench.force, hand, target, h);
    step_rotation(wrench.torque, hand, target, h);
  }
}

void HandleBody::step_translation(const DVec3& force, const HandImpedance& hand, const RigidMotion& target,
                                  double dt) {
  const double mass = properties_.mass + hand.mass;
  const DVec3 spring = hand.stiffness * (target.position - motion_.position);
  const DVec3 push = force + spring + hand.damping * target.linear_velocity + stop_force();
  DVec3& velocity = motion_.linear_velocity;
  velocity = (velocity + (dt / mass) * push) / (1.0 + dt * (properties_.damping + hand.damping) / mass);
  velocity = after_friction(velocity, dt * properties_.friction / mass);
  const DVec3 moved = dt * velocity;
  motion_.position += moved;
  energy_.by_actuators += glm::dot(force, moved);
  energy_.by_hand += glm::dot(spring + hand.damping * (target.linear_velocity - velocity), moved);
}

void HandleBody::step_rotation(const DVec3& torque, const HandImpedance& hand, const RigidMotion& target,
                               double dt) {
  const double inertia = properties_.inertia + hand.inertia;
  const DVec3 spring = hand.angular_stiffness * rotation_between(motion_.orientation, target.orientation);
  const DVec3 push = torque + spring + hand.angular_damping * target.angular_velocity;
  DVec3& velocity = motion_.angular_velocity;
  velocity = (velocity + (dt / inertia) * push) /
             (1.0 + dt * (properties_.angular_damping + hand.angular_damping) / inertia);
  velocity = after_friction(velocity, dt * properties_.angular_friction / inertia);
  const DVec3 turned = dt * velocity;
  motion_.orientation = slightly_turned(motion_.orientation, turned);
  energy_.by_actuators += glm::dot(torque, turned);
  energy_.by_hand += glm::dot(spring + hand.angular_damping * (target.angular_velocity - velocity), turned);
}

DVec3 HandleBody::stop_force() const {
  DVec3 force(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double at = motion_.position[axis];
    const double beyond = at - std::fmin(std::fmax(at, workspace_.low[axis]), workspace_.high[axis]);
    if (beyond != 0.0) force[axis] = -kStopStiffness * beyond - kStopDamping * motion_.linear_velocity[axis];
  }
  return force;
}

}  // namespace palpate
