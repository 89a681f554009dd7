#include "samples/hid_device/mass.h"

#include <cmath>

namespace palpate::hid_device {
namespace {

constexpr double kMass = 0.1;           // kg
constexpr double kStiffness = 150.0;    // N/m, of the hand
constexpr double kDamping = 4.0;        // N·s/m
constexpr double kInertia = 1e-4;       // kg·m²
constexpr double kTurnStiffness = 0.3;  // N·m/rad
constexpr double kTurnDamping = 0.01;   // N·m·s/rad

// A small turn about the axes of the base frame.
void turn(std::array<double, 4>& q, const Vector& by) {
  const auto [x, y, z, w] = q;
  q[0] += 0.5 * (by[0] * w + by[1] * z - by[2] * y);
  q[1] += 0.5 * (by[1] * w + by[2] * x - by[0] * z);
  q[2] += 0.5 * (by[2] * w + by[0] * y - by[1] * x);
  q[3] -= 0.5 * (by[0] * x + by[1] * y + by[2] * z);
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) part /= length;
}

}  // namespace

// Velocity first, then position by the new velocity: that order does not make energy.
void Mass::step(const Vector& force, const Vector& torque, double dt) {
  Vector turned{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double pull = kStiffness * (wanted_[i] - motion_.position[i]) - kDamping * motion_.velocity[i];
    motion_.velocity[i] += dt * (force[i] + pull) / kMass;
    motion_.position[i] += dt * motion_.velocity[i];
    const double angle = 2.0 * motion_.orientation[i] * std::copysign(1.0, motion_.orientation[3]);
    const double twist = -kTurnStiffness * angle - kTurnDamping * motion_.turn_rate[i];
    motion_.turn_rate[i] += dt * (torque[i] + twist) / kInertia;
    turned[i] = dt * motion_.turn_rate[i];
  }
  turn(motion_.orientation, turned);
}

}  // namespace palpate::hid_device
