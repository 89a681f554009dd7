#include <algorithm>

#include "capi/src/handles.h"
#include "capi/src/structs.h"
#include "capi/src/text.h"
#include "engine/device/registry.h"

namespace palpate::capi {
namespace {

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
    write_struct(info_of(object->device->info()), info, "info");
  });
}
