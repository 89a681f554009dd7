#include "engine/runtime/tool_grip.h"

namespace palpate {

ToolGrip::ToolGrip(const DeviceMapping& mapping) : mapping_(mapping), held_(!mapping.keep_tool_pose) {}

Pose ToolGrip::follow(const DeviceState& state, const Pose& tool) {
  const Pose& base = mapping_.world_from_base;
  const Pose handle = pose_from(mapping_.motion_scale * state.tool.position, state.tool.orientation);
  world_from_handle_ = {base.rotation * handle.rotation, base * handle.translation + offset_};
  if (mapping_.clutch != 0 && (state.buttons & mapping_.clutch) == mapping_.clutch) {
    held_ = false;
    return tool;
  }
  if (!held_) take_up(tool);
  return world_from_handle_ * mapping_.handle_from_tool;
}

DeviceWrench ToolGrip::on_hand(const Wrench& on_tool, const DVec3& reference) const {
  if (!held_) return {};
  const DVec3& handle = world_from_handle_.translation;
  const DVec3 torque = on_tool.torque + glm::cross(reference - handle, on_tool.force);
  const DMat3 base_from_world = glm::transpose(mapping_.world_from_base.rotation);
  return {mapping_.force_scale * (base_from_world * on_tool.force),
          mapping_.force_scale / mapping_.motion_scale * (base_from_world * torque)};
}

// The tool stays where it is: the handle comes to the place on the tool that it held before, and holds it as
// it is turned now.
void ToolGrip::take_up(const Pose& tool) {
  const DVec3 held_place = inverse(mapping_.handle_from_tool).translation;
  const DVec3 moved = tool * held_place - world_from_handle_.translation;
  offset_ += moved;
  world_from_handle_.translation += moved;
  mapping_.handle_from_tool = inverse(world_from_handle_) * tool;
  held_ = true;
}

}  // namespace palpate
