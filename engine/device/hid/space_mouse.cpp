#include "engine/device/hid/space_mouse.h"

#include <utility>

namespace palpate {
namespace {

// A cap that is pushed reports every 16 ms, one that has been let go sends zeros three times and falls
// silent. So a push that is not repeated is one whose end was lost.
constexpr double kSilence = 0.1;  // s
constexpr double kUpdateRate = 62.5;
constexpr double kReach = 0.3;  // m, each way
constexpr int kButtons = 32;    // as many as a report may name; a device does not tell how many there are

const Box kWorkspace{DVec3(-kReach), DVec3(kReach)};

DeviceInfo info_of(const HidEntry& entry) {
  DeviceInfo info;
  info.identity = {"hid:" + entry.name.text(), entry.product, entry.name.serial};
  info.capabilities = {kAllDegrees, 0, kButtons};
  info.limits.update_rate = kUpdateRate;
  info.limits.workspace = kWorkspace;
  return info;
}

// From the device's axes, z down and y towards the user, to the base frame's.
std::array<double, 6> deflection_of(const SpaceMouseReport& report) {
  std::array<double, 6> out{};
  for (std::size_t first : {std::size_t{0}, std::size_t{3}}) {
    constexpr double kFull = SpaceMouseReport::kFullDeflection;
    out[first] = report.axes[first] / kFull;
    out[first + 1] = -report.axes[first + 2] / kFull;
    out[first + 2] = report.axes[first + 1] / kFull;
  }
  return out;
}

}  // namespace

SpaceMouse::SpaceMouse(std::shared_ptr<HidConnection> connection)
    : info_(info_of(connection->entry())),
      control_(RateGains{}, kWorkspace),
      link_(std::move(connection), *this) {
  link_.start();
}

DeviceState SpaceMouse::read() {
  to_servo_.fetch();
  const Heard& heard = to_servo_.front();
  DeviceState state;
  state.tool = control_.motion();
  state.time = time_;
  state.sequence = sequence_;
  state.buttons = heard.report.buttons;
  state.calibrated = true;
  state.condition = heard.lost ? DeviceCondition::kLost : DeviceCondition::kReady;
  return state;
}

void SpaceMouse::step(double dt) {
  const Heard& heard = to_servo_.front();
  heard_.update(heard.count, dt);
  const bool pushed = !heard.lost && heard_.age() <= kSilence;
  control_.push(pushed ? deflection_of(heard.report) : std::array<double, 6>{});
  control_.step(dt);
  time_ += dt;
  ++sequence_;
}

bool SpaceMouse::accept(HidConnection&) {
  newest_.lost = false;
  publish();
  return true;
}

void SpaceMouse::show() {
  ++newest_.count;
  publish();
}

void SpaceMouse::lost() {
  newest_.report = {};
  newest_.lost = true;
  publish();
}

void SpaceMouse::publish() {
  to_servo_.back() = newest_;
  to_servo_.publish();
}

}  // namespace palpate
