#include "capi/src/handles.h"
#include "capi/src/numbers.h"
#include "capi/src/structs.h"

namespace palpate::capi {
namespace {

constexpr double kLargestScale = 1e9;
constexpr double kShortestLever = 1e-3, kLongestLever = 1.0;  // metres

// Written so that a NaN is refused.
double scale(double number, double smallest, const char* name) {
  if (!(number >= smallest && number <= kLargestScale)) refuse_argument(name, " is out of range");
  return number;
}

DVec3 lever(const double given[3]) {
  const DVec3 lever(given[0], given[1], given[2]);
  const double length = glm::length(lever);
  if (length != 0.0 && !(length >= kShortestLever && length <= kLongestLever))
    refuse_argument("mapping->torque_lever", " is neither zero nor 0.001 to 1 metre long");
  return lever;
}

DeviceMapping mapping_in(const plp_device_mapping& given, const Space& space) {
  if ((given.flags & ~std::uint32_t{PLP_DEVICE_KEEP_TOOL_POSE}) != 0) {
    refuse_argument("mapping->flags", " has an unknown flag");
  }
  if (given.reserved != 0) refuse_argument("mapping->reserved", " is not zero");
  DeviceMapping mapping;
  mapping.world_from_base = space.pose_in(given.scene_from_base, "mapping->scene_from_base");
  mapping.handle_from_tool = space.pose_in(given.handle_from_tool, "mapping->handle_from_tool");
  mapping.motion_scale = scale(given.motion_scale, 1.0 / kLargestScale, "mapping->motion_scale");
  mapping.force_scale = scale(given.force_scale, 0.0, "mapping->force_scale");
  mapping.torque_lever = lever(given.torque_lever);
  mapping.clutch = given.clutch_buttons;
  mapping.keep_tool_pose = (given.flags & PLP_DEVICE_KEEP_TOOL_POSE) != 0;
  return mapping;
}

DeviceMapping checked_mapping(const plp_device_mapping* given, const Space& space) {
  return given ? mapping_in(read_struct(given, "mapping"), space) : DeviceMapping{};
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_device_mapping_init(plp_device_mapping* mapping, size_t size) {
  plp_device_mapping filled{};
  filled.scene_from_base.orientation[3] = 1.0;
  filled.handle_from_tool.orientation[3] = 1.0;
  filled.motion_scale = 1.0;
  filled.force_scale = 1.0;
  fill_struct(filled, mapping, size);
}

plp_result plp_scene_set_device(plp_scene scene, plp_device device, const plp_device_mapping* mapping) {
  return guarded([&] {
    const auto object = scene_table().pin(bits_of(scene));
    require_handle(object, "scene");
    const DeviceMapping checked = checked_mapping(mapping, object->space);
    std::shared_ptr<GuardedDevice> shared;
    if (device) {
      const auto given = device_table().pin(bits_of(device));
      require_handle(given, "device");
      shared = given->device;
    }
    value_or_refuse(object->threads.set_device(std::move(shared), checked));
  });
}
