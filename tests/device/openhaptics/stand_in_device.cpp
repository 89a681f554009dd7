#include "tests/device/openhaptics/stand_in_device.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/device/rotation_vector.h"
#include "engine/device/simulated/recorded_motion.h"

namespace palpate::test {
namespace {

constexpr double kMillimetres = 1e3;  // of a metre
constexpr double kTick = 1e-3;        // s
constexpr hd::ErrorCode kUnknown = 0x0100;

// Of a device itself: beyond it, it switches its amplifiers off.
double force_of(const double* force) {
  return std::hypot(force[0], force[1], force[2]);
}

}  // namespace

StandInDevice::StandInDevice(const char* name, const char* model, const PhantomSpec& spec, int styles)
    : name_(name), model_(model), spec_(spec), styles_(styles), phantom_(spec) {}

void StandInDevice::open() {
  record_.open = true;
  record_.output = false;
  in_frame_ = false;
}

void StandInDevice::close() {
  record_.open = false;
  record_.output = false;
}

void StandInDevice::set(const StandInFaults& new_faults) {
  const bool moves = !std::equal(new_faults.hand, new_faults.hand + 3, faults.hand) ||
                     !std::equal(new_faults.turn, new_faults.turn + 3, faults.turn);
  faults = new_faults;
  if (!moves) return;
  const DVec3 place(faults.hand[0], faults.hand[1], faults.hand[2]);
  phantom_.set_motion(
      RecordedMotion::from({{0.0, {place, rotation_by({faults.turn[0], faults.turn[1], faults.turn[2]})}}})
          .value());
}

StandInRecord StandInDevice::record() const {
  StandInRecord record = record_;
  const RigidMotion& tool = phantom_.true_motion();
  std::copy_n(&tool.position.x, 3, record.handle);
  const DQuat& turn = tool.orientation;
  const double parts[4] = {turn.x, turn.y, turn.z, turn.w};
  std::copy_n(parts, 4, record.orientation);
  return record;
}

void StandInDevice::step() {
  if (record_.open) record_.missed_frames += record_.frames == frames_before_ ? 1 : 0;
  frames_before_ = record_.frames;
  DeviceWrench wrench;
  if (record_.output && record_.open && !faults.unplugged) {
    wrench.force = {record_.force[0], record_.force[1], record_.force[2]};
    wrench.torque = DVec3{record_.torque[0], record_.torque[1], record_.torque[2]} / kMillimetres;
    if (wrench.force != DVec3(0.0) || wrench.torque != DVec3(0.0)) ++record_.pushes;
  }
  record_.most_force = std::max(record_.most_force, glm::length(wrench.force));
  phantom_.write(wrench);
  phantom_.step(kTick);
  ++steps_;
}

hd::ErrorCode StandInDevice::begin_frame() {
  if (faults.unplugged) return hd::kCommunication;
  std::fill_n(force_, 3, 0.0);
  std::fill_n(torque_, 3, 0.0);
  in_frame_ = !faults.swallows_frames;
  const hd::ErrorCode once = std::exchange(faults.error_once, 0);
  return once ? once : faults.error;
}

hd::ErrorCode StandInDevice::end_frame() {
  if (faults.unplugged) return hd::kCommunication;
  if (!in_frame_) return hd::kFrame;
  in_frame_ = false;
  ++record_.frames;
  std::copy_n(force_, 3, record_.force);
  std::copy_n(torque_, 3, record_.torque);
  if (force_of(force_) <= spec_.limits.max_force * (1.0 + 1e-9)) return 0;
  record_.output = false;
  return hd::kExceededForce;
}

hd::ErrorCode StandInDevice::set_output(bool on) {
  record_.output_changes += record_.output != on ? 1 : 0;
  record_.output = on;
  return 0;
}

hd::ErrorCode StandInDevice::set_doubles(hd::Enum what, const double* numbers) {
  if (what != hd::kForce && what != hd::kTorque) return kUnknown;
  if (what == hd::kTorque && !has_torque()) {
    ++record_.torques_refused;
    return kUnknown;
  }
  if (!in_frame_) {
    ++record_.sets_outside;
    return hd::kFrame;
  }
  std::copy_n(numbers, 3, what == hd::kForce ? force_ : torque_);
  return 0;
}

bool StandInDevice::has_torque() const {
  return spec_.capabilities.actuated == kAllDegrees;
}

hd::ErrorCode StandInDevice::get_doubles(hd::Enum what, double* numbers) const {
  const RigidMotion tool = phantom_.true_motion();
  switch (what) {
    case hd::kTransform:
      get_transform(numbers);
      return 0;
    case hd::kVelocity:
      for (int i = 0; i < 3; ++i) numbers[i] = kMillimetres * tool.linear_velocity[i];
      return 0;
    case hd::kAngularVelocity:
      for (int i = 0; i < 3; ++i) numbers[i] = tool.angular_velocity[i];
      return 0;
    case hd::kTemperatures:
      std::fill_n(numbers, 6, 0.0);
      numbers[4] = faults.temperature;
      return 0;
    case hd::kUsableWorkspace:
      for (int i = 0; i < 3; ++i) numbers[i] = kMillimetres * spec_.limits.workspace.low[i];
      for (int i = 0; i < 3; ++i) numbers[3 + i] = kMillimetres * spec_.limits.workspace.high[i];
      return 0;
    default:
      return get_limit(what, numbers);
  }
}

void StandInDevice::get_transform(double* numbers) const {
  const RigidMotion& tool = phantom_.true_motion();
  const DMat3 rotation = glm::mat3_cast(tool.orientation);
  std::fill_n(numbers, 16, 0.0);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) numbers[4 * column + row] = rotation[column][row];
  const double stride = faults.strides && steps_ % 2 == 1 ? 0.1 : 0.0;
  for (int i = 0; i < 3; ++i) numbers[12 + i] = kMillimetres * (tool.position[i] + stride);
  numbers[15] = 1.0;
  if (faults.sends_nan) numbers[13] = std::numeric_limits<double>::quiet_NaN();
}

hd::ErrorCode StandInDevice::get_limit(hd::Enum what, double* number) const {
  const DeviceLimits& limits = spec_.limits;
  switch (what) {
    case hd::kMaxForce:
      *number = faults.force_limits_times * limits.max_force;
      return 0;
    case hd::kContinuousForce:
      *number = faults.force_limits_times * limits.continuous_force;
      return 0;
    case hd::kMaxStiffness:
      *number = limits.max_stiffness / kMillimetres;
      return 0;
    case hd::kMaxDamping:
      *number = limits.max_damping / kMillimetres;
      return 0;
    case hd::kMaxTorque:
    case hd::kContinuousTorque:
      *number = faults.torque_limits_times * limits.max_torque * kMillimetres;
      return 0;
    default:
      return kUnknown;
  }
}

hd::ErrorCode StandInDevice::get_integer(hd::Enum what, int* number) const {
  switch (what) {
    case hd::kButtons:
      *number = static_cast<int>(faults.buttons);
      return 0;
    case hd::kInputDegrees:
      *number = 6;
      return 0;
    case hd::kOutputDegrees:
      *number = has_torque() ? 6 : 3;
      return 0;
    case hd::kCalibrationStyles:
      *number = styles_;
      return 0;
    default:
      return kUnknown;
  }
}

hd::ErrorCode StandInDevice::get_boolean(hd::Enum what, hd::Boolean* truth) const {
  if (what != hd::kInkwellSwitch) return kUnknown;
  *truth = faults.in_inkwell ? 0 : 1;
  return 0;
}

void StandInDevice::update_calibration(int style) {
  ++record_.updates;
  record_.updates_with_output += record_.output ? 1 : 0;
  record_.last_style = style;
  if (style == styles_ && faults.updating_helps) faults.calibration = hd::kCalibrated;
}

}  // namespace palpate::test
