#include "tests/device/virtual_wall.h"

#include <algorithm>
#include <cmath>

#include "engine/device/simulated/scripted_motion.h"

namespace palpate {
namespace {

constexpr double kDuration = 1.7;    // s
constexpr double kObserved = 0.5;    // s at the end
constexpr double kRestSpeed = 1e-3;  // m/s: slower counts as at rest
constexpr double kUnlimited = 1e9;   // N

std::shared_ptr<const HandMotion> press(double force, const HandImpedance& hand) {
  constexpr double kHeight = 5e-3;
  ScriptParameters parameters;
  parameters.origin.position = {0.0, kHeight, 0.0};
  parameters.depth = kHeight + force / hand.stiffness;
  parameters.period = 0.2;
  return std::make_shared<ScriptedMotion>(HandScript::kPress, parameters);
}

bool is_stable(const VirtualWall& wall) {
  for (const double force : {0.5, 1.0, 3.0}) {
    // Written so that a speed that is not a number is not stable.
    if (!(residual_speed(wall, force) <= kRestSpeed)) return false;
  }
  return true;
}

}  // namespace

double residual_speed(const VirtualWall& wall, double force) {
  PhantomSpec spec = wall.spec;
  spec.limits.max_force = kUnlimited;
  SimulatedPhantom phantom(spec, wall.delay);
  phantom.set_hand(wall.hand);
  phantom.set_motion(press(force, wall.hand));
  phantom.place_in_hand();
  const int ticks = static_cast<int>(kDuration / wall.period);
  const int observed = static_cast<int>(kObserved / wall.period);
  double squares = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const double depth = std::max(0.0, -phantom.read().tool.position.y);
    phantom.write({DVec3(0.0, wall.stiffness * depth, 0.0), DVec3(0.0)});
    phantom.step(wall.period);
    const double speed = phantom.true_motion().linear_velocity.y;
    if (i >= ticks - observed) squares += speed * speed;
  }
  return std::sqrt(squares / observed);
}

double largest_stable_stiffness(VirtualWall wall) {
  constexpr double kGrowth = 1.25;
  constexpr double kPrecision = 1.02;
  double stable = 100.0;
  for (wall.stiffness = stable; is_stable(wall); wall.stiffness *= kGrowth) stable = wall.stiffness;
  double unstable = wall.stiffness;
  while (unstable > kPrecision * stable) {
    wall.stiffness = std::sqrt(stable * unstable);
    (is_stable(wall) ? stable : unstable) = wall.stiffness;
  }
  return stable;
}

double damping_bound(const VirtualWall& wall) {
  return (wall.spec.handle.damping + wall.hand.damping) / (wall.period * (0.5 + wall.delay));
}

double friction_bound(const VirtualWall& wall) {
  return 2.0 * wall.spec.handle.friction / wall.spec.limits.position_resolution;
}

}  // namespace palpate
