#include <algorithm>

#include "capi/src/handles.h"
#include "capi/src/structs.h"
#include "capi/src/text.h"
#include "engine/device/registry.h"

namespace palpate::capi {
namespace {

static_assert(static_cast<int>(DeviceCondition::kReady) == PLP_CONDITION_READY);
static_assert(static_cast<int>(DeviceCondition::kNeedsCalibration) == PLP_CONDITION_NEEDS_CALIBRATION);
static_assert(static_cast<int>(DeviceCondition::kWarmMotors) == PLP_CONDITION_WARM_MOTORS);
static_assert(static_cast<int>(DeviceCondition::kExceededForce) == PLP_CONDITION_EXCEEDED_FORCE);
static_assert(static_cast<int>(DeviceCondition::kExceededVelocity) == PLP_CONDITION_EXCEEDED_VELOCITY);
static_assert(static_cast<int>(DeviceCondition::kLost) == PLP_CONDITION_LOST);
static_assert(static_cast<int>(DeviceCondition::kFailed) == PLP_CONDITION_FAILED);
static_assert(static_cast<int>(DeviceCondition::kNoLibrary) == PLP_CONDITION_NO_LIBRARY);
static_assert(static_cast<int>(DeviceCondition::kWrongLibrary) == PLP_CONDITION_WRONG_LIBRARY);
static_assert(static_cast<int>(DeviceCondition::kCannotOpen) == PLP_CONDITION_CANNOT_OPEN);
static_assert(static_cast<int>(DeviceCondition::kWithheld) == PLP_CONDITION_WITHHELD);

void store_limits(const DeviceLimits& limits, plp_device_info& out) {
  out.max_force = limits.max_force;
  out.continuous_force = limits.continuous_force;
  out.max_torque = limits.max_torque;
  out.continuous_torque = limits.continuous_torque;
  out.max_stiffness = limits.max_stiffness;
  out.max_damping = limits.max_damping;
  out.position_resolution = limits.position_resolution;
  out.angle_resolution = limits.angle_resolution;
  out.update_rate = limits.update_rate;
  if (limits.workspace.empty()) return;
  store(limits.workspace.low, out.workspace_min);
  store(limits.workspace.high, out.workspace_max);
}

plp_device_info info_of(const DeviceInfo& info) {
  plp_device_info out{};
  out.buttons = static_cast<std::uint32_t>(info.capabilities.buttons);
  out.sensed = info.capabilities.sensed;
  out.actuated = info.capabilities.actuated;
  store_text(info.identity.uri, out.uri);
  store_text(info.identity.name, out.name);
  store_text(info.identity.serial, out.serial);
  store_limits(info.limits, out);
  out.condition = static_cast<std::int32_t>(info.condition);
  store_text(info.advice.empty() ? std::string(advice_on(info.condition)) : info.advice, out.status);
  return out;
}

// The i-th of a caller's structs, which may be shorter or longer than this version's.
plp_device_info* info_at(plp_device_info* infos, std::size_t i, std::uint32_t size) {
  return reinterpret_cast<plp_device_info*>(reinterpret_cast<unsigned char*>(infos) + i * size);
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_device_info_init(plp_device_info* info, size_t size) {
  fill_struct(plp_device_info{}, info, size);
}

plp_result plp_device_list(plp_device_info* infos, size_t capacity, size_t* count) {
  return guarded([&] {
    require(count, "count is null");
    const std::uint32_t size = capacity > 0 ? checked_size(infos, "infos") : 0;
    const std::vector<DeviceInfo> found = DeviceRegistry::standard().enumerate();
    for (std::size_t i = 0; i < std::min(found.size(), capacity); ++i) {
      plp_device_info* const info = info_at(infos, i, size);
      std::memcpy(info, &size, sizeof size);
      write_struct(info_of(found[i]), info, "infos");
    }
    *count = found.size();
  });
}

plp_result plp_device_get_info(plp_device device, plp_device_info* info) {
  return guarded([&] {
    const auto object = device_table().pin(bits_of(device));
    require_handle(object, "device");
    DeviceInfo now = object->device->info();
    now.condition = object->device->status().state.condition;
    now.advice = object->device->advice(now.condition);
    write_struct(info_of(now), info, "info");
  });
}
