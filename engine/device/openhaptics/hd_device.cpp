#include "engine/device/openhaptics/hd_device.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/device/finite.h"
#include "engine/device/openhaptics/hd_error.h"
#include "engine/device/openhaptics/hd_scheduler.h"

namespace palpate {
namespace {

constexpr double kMetre = 1e-3;             // of a millimetre
constexpr double kNewtonMillimetres = 1e3;  // of a newton-metre

constexpr double kOrderLasts = 0.010;        // s: a wrench that nobody renews is none
constexpr double kStallIsLoss = 1.0;         // s without a tick of the scheduler
constexpr double kLetGo = 0.5;               // s without force after the device has exceeded something
constexpr double kCool = 0.8;                // temperature at which warm motors may push again
constexpr double kTooHot = 0.95;             // at which they let go before the device does
constexpr double kCalibrationPause = 0.1;    // s from one update to the next
constexpr hd::Handle kLargestHandle = 1024;  // versions of the library return garbage beyond it for no device
constexpr std::uint64_t kTemperatureEvery = 64;  // ticks

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

DVec3 vector_of(const double* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

// The rotation in a 4 × 4 matrix by columns; of a matrix that has none, a quaternion that the limits refuse.
DQuat rotation_in(const double* matrix) {
  const DMat3 rotation(vector_of(matrix), vector_of(matrix + 4), vector_of(matrix + 8));
  const DQuat quaternion = glm::quat_cast(rotation);
  constexpr double kUnitSlack = 1e-3;
  return std::abs(glm::length(quaternion) - 1.0) < kUnitSlack ? glm::normalize(quaternion) : quaternion;
}

// What motors can do of a vector: its direction, up to their maximum, and nothing of one that is none.
DVec3 saturated(const DVec3& wanted, double most) {
  const double length = glm::length(wanted);
  if (!std::isfinite(length)) return DVec3(0.0);
  return length > most ? wanted * (most / length) : wanted;
}

}  // namespace

Result<std::unique_ptr<Device>> HdDevice::open(HdScheduler& scheduler, std::string name, std::string uri) {
  std::unique_ptr<HdDevice> device(new HdDevice(scheduler, std::move(name), std::move(uri)));
  if (Status opened = scheduler.open(*device); !opened) return opened.error();
  return std::unique_ptr<Device>(std::move(device));
}

HdDevice::HdDevice(HdScheduler& scheduler, std::string name, std::string uri)
    : scheduler_(scheduler), call_(scheduler.call), name_(std::move(name)), uri_(std::move(uri)) {}

HdDevice::~HdDevice() {
  scheduler_.close(*this);
}

DeviceState HdDevice::read() {
  samples_.fetch();
  return samples_.front();
}

void HdDevice::write(const DeviceWrench& wrench) {
  orders_.back() = wrench;
  orders_.publish();
}

std::optional<DeviceState> HdDevice::glance() {
  const std::lock_guard lock(asking_);
  shown_.fetch();
  DeviceState state = shown_.front().state;
  if (now() - shown_.front().time > kStallIsLoss) state.condition = DeviceCondition::kLost;
  return state;
}

bool HdDevice::calibrate() {
  if ((facts_.calibration_styles & hd::kByEncoderReset) == 0) return false;
  asked_to_calibrate_.raise();
  return true;
}

std::string HdDevice::advice(DeviceCondition condition) const {
  if (condition == DeviceCondition::kFailed) {
    const std::lock_guard lock(asking_);
    shown_.fetch();
    const char* const text = call_.hdGetErrorString(shown_.front().last_error);
    return std::string(advice_on(condition)) + (text ? std::string(": ") + text : std::string());
  }
  if (condition != DeviceCondition::kNeedsCalibration) return Device::advice(condition);
  if (facts_.calibration_styles & hd::kByInkwell)
    return "not calibrated: put the stylus into its inkwell for a moment";
  if (facts_.calibration_styles & hd::kByItself)
    return "not calibrated: move the handle slowly to the ends of its workspace";
  return "not calibrated: hold the arm so that all its links are at right angles, and calibrate it there "
         "(plp_device_calibrate)";
}

Status HdDevice::connect() {
  if (Status initialised = initialise(); !initialised) return initialised;
  scheduler_.set_rate();
  facts_ = read_facts(call_, uri_);
  facts_.info.limits.update_rate = scheduler_.rate_hz();
  most_force_ = facts_.info.limits.max_force;
  most_torque_ = facts_.info.limits.max_torque;
  configure();
  return Done{};
}

Status HdDevice::initialise() {
  clear_errors(call_);
  const hd::Handle handle = call_.hdInitDevice(name_.empty() ? nullptr : name_.c_str());
  const hd::ErrorInfo error = clear_errors(call_);
  if (error.code != 0 || handle > kLargestHandle) return opening_error(call_, name_, error);
  handle_ = handle;
  call_.hdMakeCurrentDevice(handle_);
  return Done{};
}

// Also takes the first sample, so that the state is one before any tick.
void HdDevice::configure() {
  for (const hd::Enum capability : {hd::kForceClamping, hd::kForceRamping}) call_.hdEnable(capability);
  call_.hdDisable(hd::kForceOutput);
  clear_errors(call_);
  output_ = false;
  condition_ = DeviceCondition::kReady;
  let_go_for_ = 0.0;
  const double time = now();
  call_.hdBeginFrame(handle_);
  sense(time);
  call_.hdEndFrame(handle_);
  note_errors();
  publish(time, false);
}

void HdDevice::disconnect() {
  if (!is_connected()) return;
  call_.hdMakeCurrentDevice(handle_);
  call_.hdDisable(hd::kForceOutput);
  call_.hdDisableDevice(handle_);
  clear_errors(call_);
  handle_ = hd::kNoDevice;
}

bool HdDevice::take_up(double time) {
  sought_ = time;
  if (!initialise()) return false;
  const DeviceLimits limits = read_facts(call_, uri_).info.limits;
  most_force_ = std::min(facts_.info.limits.max_force, limits.max_force);
  most_torque_ = std::min(facts_.info.limits.max_torque, limits.max_torque);
  configure();
  if (condition_ == DeviceCondition::kLost) return false;
  lost_.lower();
  return true;
}

void HdDevice::tick(double dt, bool silent) {
  const bool here = !is_lost();
  const double time = now();
  recover(dt);
  if (here) {
    call_.hdBeginFrame(handle_);
    sense(time);
  }
  publish(time, silent);
  rider_.use([dt](ServoTask& servo) { servo.tick(dt); });
  if (here) actuate(dt, silent);
}

// A sample with which an error came is none.
void HdDevice::sense(double time) {
  DeviceState sample = state_;
  read_motion(sample.tool);
  sample.buttons = read_buttons();
  if (facts_.has_temperatures && ticks_ % kTemperatureEvery == 0) sample.temperature = read_temperature();
  ++ticks_;
  sample.time = time;
  ++sample.sequence;
  if (!note_errors()) state_ = sample;
  check_calibration();
  if (state_.temperature > kTooHot) note(hd::kWarmMotors);
}

void HdDevice::read_motion(RigidMotion& tool) const {
  double transform[16] = {}, velocity[3] = {}, turning[3] = {};
  call_.hdGetDoublev(hd::kTransform, transform);
  call_.hdGetDoublev(hd::kVelocity, velocity);
  call_.hdGetDoublev(hd::kAngularVelocity, turning);
  tool.position = kMetre * vector_of(transform + 12);
  tool.orientation = rotation_in(transform);
  tool.linear_velocity = kMetre * vector_of(velocity);
  tool.angular_velocity = vector_of(turning);
}

std::uint32_t HdDevice::read_buttons() const {
  int held = 0;
  call_.hdGetIntegerv(hd::kButtons, &held);
  const auto plain = static_cast<std::uint32_t>(held) & ((1u << facts_.plain_buttons) - 1);
  if (!facts_.has_inkwell) return plain;
  hd::Boolean out = 0;
  call_.hdGetBooleanv(hd::kInkwellSwitch, &out);
  return plain | (out ? 1u << facts_.plain_buttons : 0u);
}

double HdDevice::read_temperature() const {
  std::array<double, 16> temperatures{};
  call_.hdGetDoublev(hd::kTemperatures, temperatures.data());
  return *std::max_element(temperatures.begin(), temperatures.end());
}

// Encoders are reset only when a hand holds the arm where they are to be zero.
void HdDevice::check_calibration() {
  const hd::Enum answer = call_.hdCheckCalibration();
  const bool asked = asked_to_calibrate_.lower();
  const int by_itself = facts_.calibration_styles & (hd::kByItself | hd::kByInkwell);
  update_style_ = 0;
  if (asked)
    update_style_ = hd::kByEncoderReset;
  else if (answer == hd::kCalibrationToUpdate && since_update_ >= kCalibrationPause)
    update_style_ = by_itself & hd::kByItself ? hd::kByItself : by_itself;
  state_.calibrated = answer == hd::kCalibrated && !asked;
}

// Whether there were any.
bool HdDevice::note_errors() {
  bool any = false;
  scheduler_.take_errors(handle_, [this, &any](hd::ErrorCode code) {
    note(code);
    any = true;
  });
  return any;
}

// The worst of several counts, which is that the device is lost.
void HdDevice::note(hd::ErrorCode code) {
  const DeviceCondition seen = condition_of(code);
  if (condition_ != DeviceCondition::kLost) condition_ = seen;
  if (seen == DeviceCondition::kFailed) last_error_ = code;
  let_go_for_ = kLetGo;
}

void HdDevice::recover(double dt) {
  since_update_ += dt;
  let_go_for_ -= dt;
  if (!is_fault(condition_) || condition_ == DeviceCondition::kLost || let_go_for_ > 0.0) return;
  if (condition_ == DeviceCondition::kWarmMotors && state_.temperature > kCool) return;
  condition_ = DeviceCondition::kReady;
}

// Before a rest of the scheduler a pose is none to turn into force, so that force fades in after it.
void HdDevice::publish(double time, bool silent) {
  const bool needs_calibration = condition_ == DeviceCondition::kReady && !state_.calibrated;
  state_.condition = needs_calibration ? DeviceCondition::kNeedsCalibration : condition_;
  DeviceState shown = state_;
  shown.calibrated = shown.calibrated && !silent;
  samples_.back() = shown;
  samples_.publish();
  shown_.back() = {shown, time, last_error_};
  shown_.publish();
}

void HdDevice::actuate(double dt, bool silent) {
  const DeviceWrench wrench = wrench_to_send(dt, silent);
  set_output(may_push());
  if (condition_ != DeviceCondition::kLost) send(wrench);
  call_.hdEndFrame(handle_);
  note_errors();
  update_calibration();
  if (condition_ == DeviceCondition::kLost) lost_.raise();
}

void HdDevice::send(const DeviceWrench& wrench) {
  const double force[3] = {wrench.force.x, wrench.force.y, wrench.force.z};
  call_.hdSetDoublev(hd::kForce, force);
  if (facts_.info.capabilities.actuated & kRotations) {
    const DVec3 scaled = kNewtonMillimetres * wrench.torque;
    const double torque[3] = {scaled.x, scaled.y, scaled.z};
    call_.hdSetDoublev(hd::kTorque, torque);
  }
}

DeviceWrench HdDevice::wrench_to_send(double dt, bool silent) {
  order_age_ = orders_.fetch() ? 0.0 : order_age_ + dt;
  if (silent || !may_push() || order_age_ > kOrderLasts) return {};
  const DeviceWrench& wanted = orders_.front();
  return {saturated(wanted.force, most_force_), saturated(wanted.torque, most_torque_)};
}

// Off and on again is also what amplifiers need that have switched themselves off.
void HdDevice::set_output(bool on) {
  if (on == output_) return;
  output_ = on;
  if (on) {
    call_.hdEnable(hd::kForceOutput);
  } else {
    call_.hdDisable(hd::kForceOutput);
  }
}

// Outside a frame, and with the force off.
void HdDevice::update_calibration() {
  if (update_style_ == 0 || output_ || condition_ == DeviceCondition::kLost) return;
  since_update_ = 0.0;
  call_.hdUpdateCalibration(static_cast<hd::Enum>(update_style_));
  note_errors();
}

}  // namespace palpate
