#include "engine/device/simulated/simulated_phantom.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/device/rotation_vector.h"

namespace palpate {
namespace {

constexpr double kLongestStep = 0.1;   // s
constexpr double kLetGoAfter = 0.010;  // s without a write

// What motors can do of a vector: its direction, up to their maximum. Amplifiers ignore what is not a finite
// number.
DVec3 saturated(const DVec3& wanted, double most) {
  const double length = glm::length(wanted);
  if (!std::isfinite(length)) return DVec3(0.0);
  return length > most ? wanted * (most / length) : wanted;
}

}  // namespace

SimulatedPhantom::SimulatedPhantom(const PhantomSpec& spec, int delay)
    : info_(info_of(spec)),
      body_(spec.handle, spec.limits.workspace),
      encoder_(spec.limits.position_resolution, spec.limits.angle_resolution),
      samples_(delay) {
  if (delay > 0) info_.identity.uri += "?delay=" + std::to_string(delay);
  place_in_hand();
}

void SimulatedPhantom::write(const DeviceWrench& wrench) {
  applied_ = {saturated(wrench.force, info_.limits.max_force),
              saturated(wrench.torque, info_.limits.max_torque)};
  written_ = time_;
}

void SimulatedPhantom::step(double dt) {
  if (!(dt > 0.0)) return;
  dt = std::min(dt, kLongestStep);
  if (time_ - written_ > kLetGoAfter) applied_ = {};
  body_.step(applied_, hand_, hand_target(dt), dt);
  time_ += dt;
  ++sequence_;
  samples_.push(current_state(encoder_.sample(body_.motion(), dt)));
}

std::shared_ptr<const HandMotion> SimulatedPhantom::set_motion(std::shared_ptr<const HandMotion> motion) {
  motion_began_ = time_;
  return std::exchange(motion_, std::move(motion));
}

void SimulatedPhantom::place_in_hand() {
  const HandPose pose = intended(time_);
  RigidMotion at_rest;
  at_rest.position = pose.position;
  at_rest.orientation = pose.orientation;
  body_.place(at_rest);
  encoder_.reset(at_rest);
  ++sequence_;
  samples_.fill(current_state(encoder_.last()));
}

HandPose SimulatedPhantom::intended(double time) const {
  if (motion_) return motion_->at(time - motion_began_);
  HandPose middle;
  middle.position = info_.limits.workspace.centre();
  return middle;
}

// Where the hand intends to be now, and the constant velocity that takes it to where it intends to be then.
RigidMotion SimulatedPhantom::hand_target(double dt) const {
  const HandPose now = intended(time_);
  const HandPose then = intended(time_ + dt);
  return {now.position, now.orientation, (then.position - now.position) / dt,
          rotation_between(now.orientation, then.orientation) / dt};
}

DeviceState SimulatedPhantom::current_state(const RigidMotion& tool) const {
  return {tool, time_, sequence_, buttons_, true};
}

}  // namespace palpate
