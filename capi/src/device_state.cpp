#include <iterator>

#include "capi/src/handles.h"
#include "capi/src/structs.h"

namespace palpate::capi {
namespace {

static_assert(static_cast<int>(SafetyState::kDisarmed) == PLP_SAFETY_DISARMED);
static_assert(static_cast<int>(SafetyState::kRamping) == PLP_SAFETY_RAMPING);
static_assert(static_cast<int>(SafetyState::kArmed) == PLP_SAFETY_ARMED);
static_assert(static_cast<int>(SafetyState::kFault) == PLP_SAFETY_FAULT);
static_assert(static_cast<int>(Limiter::kLongTick) == PLP_LIMITER_LONG_TICK);
static_assert(static_cast<int>(Limiter::kNonFiniteWrench) == PLP_LIMITER_NON_FINITE_WRENCH);
static_assert(static_cast<int>(Limiter::kNonFinitePose) == PLP_LIMITER_NON_FINITE_POSE);
static_assert(static_cast<int>(Limiter::kPoseJump) == PLP_LIMITER_POSE_JUMP);
static_assert(static_cast<int>(Limiter::kStaleServo) == PLP_LIMITER_STALE_SERVO);
static_assert(static_cast<int>(Limiter::kStalePose) == PLP_LIMITER_STALE_POSE);
static_assert(static_cast<int>(Limiter::kForceClamp) == PLP_LIMITER_FORCE_CLAMP);
static_assert(static_cast<int>(Limiter::kTorqueClamp) == PLP_LIMITER_TORQUE_CLAMP);
static_assert(static_cast<int>(Limiter::kForceSlew) == PLP_LIMITER_FORCE_SLEW);
static_assert(static_cast<int>(Limiter::kTorqueSlew) == PLP_LIMITER_TORQUE_SLEW);
static_assert(static_cast<int>(Limiter::kRamp) == PLP_LIMITER_RAMP);
static_assert(static_cast<int>(Limiter::kDevice) == PLP_LIMITER_DEVICE);
static_assert(kLimiters <= std::size(plp_device_state{}.limiter_ticks));

plp_wrench wrench_of(const DeviceWrench& wrench) {
  plp_wrench out{};
  store(wrench.force, out.force);
  store(wrench.torque, out.torque);
  return out;
}

void store_motion(const RigidMotion& tool, plp_device_state& out) {
  store(tool.position, out.pose.position);
  store({tool.orientation.x, tool.orientation.y, tool.orientation.z}, out.pose.orientation);
  out.pose.orientation[3] = tool.orientation.w;
  store(tool.linear_velocity, out.linear_velocity);
  store(tool.angular_velocity, out.angular_velocity);
}

void store_report(const SafetyReport& report, plp_device_state& out) {
  out.safety = static_cast<std::int32_t>(report.state);
  out.gain = report.gain;
  for (std::size_t i = 0; i < kLimiters; ++i) {
    out.limiters |= static_cast<std::uint32_t>(report.acting[i]) << i;
    out.limiter_ticks[i] = report.ticks[i];
  }
}

plp_device_state state_of(const DeviceStatus& status) {
  plp_device_state out{};
  store_motion(status.state.tool, out);
  out.buttons = status.state.buttons;
  out.time = status.state.time;
  out.sequence = status.state.sequence;
  out.calibrated = status.state.calibrated;
  out.condition = static_cast<std::int32_t>(status.state.condition);
  out.temperature = status.state.temperature;
  out.lost = status.state.lost;
  out.commanded = wrench_of(status.wanted);
  out.applied = wrench_of(status.applied);
  out.unactuated = status.unactuated;
  out.ticks = status.ticks;
  store_report(status.safety, out);
  return out;
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_device_state_init(plp_device_state* state, size_t size) {
  fill_struct(plp_device_state{}, state, size);
}

plp_result plp_device_get_state(plp_device device, plp_device_state* state) {
  return guarded([&] {
    const auto object = device_table().pin(bits_of(device));
    require_handle(object, "device");
    write_struct(state_of(object->device->status()), state, "state");
  });
}
