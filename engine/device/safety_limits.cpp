#include "engine/device/safety_limits.h"

#include <algorithm>
#include <cmath>

#include "engine/device/finite.h"
#include "engine/device/rotation_vector.h"

namespace palpate {
namespace {

// What quantisation and a sample more or less may add to a step between two poses.
constexpr double kStepSlack = 1e-3;  // m
constexpr double kTurnSlack = 1e-2;  // rad

// Shortened to at most `limit`; squares that overflow or vanish are avoided.
DVec3 clamp_length(const DVec3& v, double limit) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0.0) return v;
  const DVec3 scaled = v / largest;
  const double longest = limit / glm::length(scaled);
  return largest <= longest ? v : longest * scaled;
}

// From 0 to 1 without a kink at either end.
double smooth(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

void SafetyLimits::restart() {
  enter(SafetyState::kDisarmed);
  report_.acting.fill(false);
  servo_ = {};
  pose_ = {};
  clean_ = 0.0;
  has_previous_ = false;
}

DeviceWrench SafetyLimits::apply(const Command& command, const DeviceState& state, double dt) {
  report_.acting.fill(false);
  if (note(Limiter::kLongTick, !(dt >= 0.0 && dt <= settings_.watchdog))) {
    dt = 0.0;
    has_previous_ = false;
    if (is_engaged()) enter(SafetyState::kRamping);
  }
  const bool faulty = find_faults(command, state, dt);
  advance_state(state, faulty, dt);
  if (!is_engaged()) return {};
  last_.force = shaped(command.wrench.force, last_.force, settings_.max_force, settings_.force_slew,
                       Limiter::kForceClamp, Limiter::kForceSlew, dt);
  last_.torque = shaped(command.wrench.torque, last_.torque, settings_.max_torque, settings_.torque_slew,
                        Limiter::kTorqueClamp, Limiter::kTorqueSlew, dt);
  note(Limiter::kRamp, report_.gain < 1.0);
  return {report_.gain * last_.force, report_.gain * last_.torque};
}

bool SafetyLimits::find_faults(const Command& command, const DeviceState& state, double dt) {
  servo_.update(command.sequence, dt);
  const bool new_pose = pose_.update(state.sequence, dt);
  const bool finite = is_finite(state);
  bool faulty = note(Limiter::kNonFiniteWrench, !is_finite(command.wrench));
  faulty |= note(Limiter::kNonFinitePose, !finite);
  faulty |= note(Limiter::kPoseJump, finite && jumped(state));
  faulty |= note(Limiter::kStaleServo, servo_.age() > settings_.watchdog);
  faulty |= note(Limiter::kStalePose, pose_.age() > settings_.watchdog);
  faulty |= note(Limiter::kDevice, is_fault(state.condition));
  if (finite && new_pose) {
    previous_ = state;
    has_previous_ = true;
  }
  return faulty;
}

// Whether a sample is farther from the one before than a hand could have moved it, or says so of itself. The
// longer of the two clocks' times counts, since ticks and samples jitter against each other, but no more than
// the watchdog's: a wild time stamp must not excuse a jump.
bool SafetyLimits::jumped(const DeviceState& state) const {
  const RigidMotion& now = state.tool;
  if (glm::length(now.linear_velocity) > settings_.max_speed) return true;
  if (glm::length(now.angular_velocity) > settings_.max_turn_rate) return true;
  if (!has_previous_) return false;
  const RigidMotion& before = previous_.tool;
  const double elapsed = std::min(std::max(state.time - previous_.time, pose_.gap()), settings_.watchdog);
  const double turn = glm::length(rotation_between(before.orientation, now.orientation));
  return glm::distance(before.position, now.position) > settings_.max_speed * elapsed + kStepSlack ||
         turn > settings_.max_turn_rate * elapsed + kTurnSlack;
}

void SafetyLimits::advance_state(const DeviceState& state, bool faulty, double dt) {
  clean_ = faulty ? 0.0 : clean_ + dt;
  if (faulty) return enter(SafetyState::kFault);
  if (report_.state == SafetyState::kFault && clean_ < settings_.fault_hold) return;
  if (!may_engage(state)) return enter(SafetyState::kDisarmed);
  if (!is_engaged()) return enter(SafetyState::kRamping);
  advance_ramp(dt);
}

void SafetyLimits::advance_ramp(double dt) {
  ramped_ = std::min(ramped_ + dt, settings_.ramp_time);
  report_.gain = ramped_ < settings_.ramp_time ? smooth(ramped_ / settings_.ramp_time) : 1.0;
  report_.state = report_.gain < 1.0 ? SafetyState::kRamping : SafetyState::kArmed;
}

void SafetyLimits::enter(SafetyState state) {
  report_.state = state;
  report_.gain = 0.0;
  ramped_ = 0.0;
  last_ = {};
}

bool SafetyLimits::may_engage(const DeviceState& state) const {
  const bool held = state.held && (state.buttons & settings_.dead_man) == settings_.dead_man;
  return wanted_ && state.calibrated && held;
}

DVec3 SafetyLimits::shaped(const DVec3& wanted, const DVec3& last, double limit, double slew, Limiter clamp,
                           Limiter slewed, double dt) {
  constexpr double kMilliseconds = 1e3;
  const DVec3 clamped = clamp_length(wanted, limit);
  const DVec3 change = clamp_length(clamped - last, slew * kMilliseconds * dt);
  note(clamp, clamped != wanted);
  const DVec3 next = change == clamped - last ? clamped : last + change;
  note(slewed, next != clamped);
  return next;
}

bool SafetyLimits::note(Limiter limiter, bool acting) {
  const auto index = static_cast<std::size_t>(limiter);
  report_.acting[index] = acting;
  report_.ticks[index] += acting ? 1 : 0;
  return acting;
}

}  // namespace palpate
