#include "engine/device/hid/ohhp_device.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "engine/device/hid/ohhp.h"

namespace palpate {
namespace {

constexpr double kWatchdog = 0.010;  // s, or less if the device has less patience
constexpr double kSilence = 0.1;     // s without a sample after which a device counts as lost

double watchdog_of(const OhhpFeatures& features) {
  return std::min(kWatchdog, features.watchdog);
}

Result<OhhpFeatures> features_of(HidConnection& connection) {
  std::array<std::uint8_t, ohhp::kFeaturesSize + 1> report{};  // a byte more: so that a longer one is noticed
  report[0] = ohhp::kFeaturesId;
  const int length = connection.out().get_feature(report);
  return parse_ohhp_features(std::span(report).first(static_cast<std::size_t>(std::max(length, 0))));
}

// Asks a device what it is, and tells it how long to wait for us.
Result<OhhpFeatures> greet(HidConnection& connection) {
  Result<OhhpFeatures> features = features_of(connection);
  if (!features) return features;
  const double milliseconds = std::max(1.0, 1e3 * watchdog_of(features.value()));
  const OhhpCommand command{OhhpCommand::Kind::kSetWatchdog, static_cast<std::uint16_t>(milliseconds)};
  if (connection.out().send_feature(ohhp_report(command))) return features;
  return Error{ErrorCode::kDevice, "it refuses feature report 4, which sets its watchdog"};
}

DeviceInfo info_of(const HidEntry& entry, const OhhpFeatures& features) {
  DeviceInfo info;
  info.identity = {"hid:" + entry.name.text(), entry.product, entry.name.serial};
  info.capabilities = features.capabilities;
  info.limits = features.limits;
  return info;
}

// Whether what the safety limits were made for still holds.
bool same(const OhhpFeatures& a, const OhhpFeatures& b) {
  return a.traits == b.traits && a.capabilities.sensed == b.capabilities.sensed &&
         a.capabilities.actuated == b.capabilities.actuated && a.watchdog == b.watchdog &&
         a.limits.max_force == b.limits.max_force && a.limits.max_torque == b.limits.max_torque;
}

DeviceCondition condition_of(const OhhpSample& sample) {
  if (sample.has(OhhpSample::kEmergency)) return DeviceCondition::kFailed;
  if (sample.has(OhhpSample::kTooHot)) return DeviceCondition::kWarmMotors;
  // It has not heard anything in time, so force must fade in anew.
  if (sample.has(OhhpSample::kArmed) && sample.has(OhhpSample::kWatchdog)) return DeviceCondition::kLost;
  return sample.has(OhhpSample::kCalibrated) ? DeviceCondition::kReady : DeviceCondition::kNeedsCalibration;
}

}  // namespace

Result<std::unique_ptr<Device>> OhhpDevice::open(std::shared_ptr<HidConnection> connection) {
  const Result<OhhpFeatures> features = greet(*connection);
  if (!features) {
    const std::string uri = "hid:" + connection->entry().name.text();
    return Error{features.error().code, uri + ": " + features.error().message};
  }
  std::unique_ptr<OhhpDevice> device(new OhhpDevice(std::move(connection), features.value()));
  device->await_first_sample();
  return std::unique_ptr<Device>(std::move(device));
}

OhhpDevice::OhhpDevice(std::shared_ptr<HidConnection> connection, const OhhpFeatures& features)
    : features_(features),
      info_(info_of(connection->entry(), features)),
      link_(std::move(connection), *this),
      writer_(link_, watchdog_of(features)) {
  // Zero is what nothing was heard of yet.
  sequence_.restart(1);
  link_.start();
  try {
    writer_.start();
  } catch (...) {
    link_.stop();  // while there is still somebody to listen
    throw;
  }
}

OhhpDevice::~OhhpDevice() {
  writer_.stop();
  link_.stop();
}

// So that a tool which is put into the hand at once does not begin at the origin.
void OhhpDevice::await_first_sample() {
  constexpr std::chrono::milliseconds kLongest{100};
  constexpr std::chrono::milliseconds kPause{1};
  for (auto waited = kPause; waited <= kLongest && glance()->sequence == 0; waited += kPause) {
    std::this_thread::sleep_for(kPause);
  }
}

// A transfer that does not end is a device that cannot be told to let go.
DeviceState OhhpDevice::read() {
  to_servo_.fetch();
  const Heard& heard = to_servo_.front();
  answered_ = heard.number;
  DeviceState state = heard.state;
  if (sending_.age() > kWatchdog && !is_fault(state.condition)) state.condition = DeviceCondition::kLost;
  return state;
}

void OhhpDevice::write(const DeviceWrench& wrench) {
  writer_.post({wrench, answered_, engaged_});
}

std::optional<DeviceState> OhhpDevice::glance() {
  const std::lock_guard lock(asking_);
  to_others_.fetch();
  return to_others_.front().state;
}

bool OhhpDevice::calibrate() {
  if (!features_.has(OhhpFeatures::kWantsCalibration)) return false;
  writer_.calibrate();
  return true;
}

std::string OhhpDevice::advice(DeviceCondition condition) const {
  if (condition == DeviceCondition::kFailed) return "its emergency stop is pressed: release it";
  if (condition == DeviceCondition::kNeedsCalibration && !features_.has(OhhpFeatures::kWantsCalibration)) {
    return "it calibrates itself: wait";
  }
  return Device::advice(condition);
}

bool OhhpDevice::accept(HidConnection& connection) {
  const Result<OhhpFeatures> features = greet(connection);
  if (!features || !same(features.value(), features_)) return false;
  sequence_.restart(1);
  time_us_.restart(static_cast<std::uint64_t>(since_lost_.elapsed_us()));
  return true;
}

void OhhpDevice::take(std::span<const std::uint8_t> report) {
  const std::optional<OhhpSample> sample = parse_ohhp_sample(report);
  if (!sample) return;
  count(*sample);
  sample_ = *sample;
  fresh_ = true;
}

// A number that is far behind the last is that of a device which has begun anew.
void OhhpDevice::count(const OhhpSample& sample) {
  constexpr std::uint16_t kBehind = 0x8000;
  if (static_cast<std::uint16_t>(sample.sequence - sample_.sequence) >= kBehind) {
    sequence_.restart(1);
    time_us_.restart(1);
  }
  const std::uint16_t step = sequence_.advance(sample.sequence);
  time_us_.advance(sample.time_us);
  newest_.state.lost += step > 1 ? step - 1u : 0u;
}

void OhhpDevice::show() {
  if (!std::exchange(fresh_, false)) return;
  DeviceState& state = newest_.state;
  state.tool = sample_.tool;
  state.time = 1e-6 * static_cast<double>(time_us_.total());
  state.sequence = sequence_.total();
  state.buttons = sample_.buttons;
  state.calibrated = sample_.has(OhhpSample::kCalibrated);
  state.condition = condition_of(sample_);
  state.temperature = sample_.temperature;
  state.held = !features_.has(OhhpFeatures::kHasDeadMan) || sample_.has(OhhpSample::kDeadMan);
  newest_.number = sample_.sequence;
  writer_.hear(sample_.has(OhhpSample::kArmed));
  publish(newest_);
}

void OhhpDevice::silent(double seconds) {
  if (seconds > kSilence) publish(DeviceCondition::kLost);
}

// A device that comes back has its amplifiers off.
void OhhpDevice::lost() {
  since_lost_ = {};
  writer_.hear(false);
  publish(DeviceCondition::kLost);
}

void OhhpDevice::publish(DeviceCondition condition) {
  newest_.state.condition = condition;
  publish(newest_);
}

void OhhpDevice::publish(const Heard& heard) {
  to_servo_.back() = heard;
  to_servo_.publish();
  to_others_.back() = heard;
  to_others_.publish();
}

}  // namespace palpate
