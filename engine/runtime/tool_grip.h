#pragma once

#include <cstdint>

#include "engine/contact/spring.h"
#include "engine/device/device_state.h"
#include "engine/device/device_wrench.h"
#include "engine/math/pose.h"

namespace palpate {

// How a device's handle holds a scene's tool. Turns are never scaled.
struct DeviceMapping {
  Pose world_from_base;         // where the device stands in the scene
  Pose handle_from_tool;        // how the tool sits in the handle, metres of the scene
  double motion_scale = 1.0;    // metres of the scene for a metre of the handle; positive
  double force_scale = 1.0;     // newtons on the hand for a newton on the tool; not negative
  std::uint32_t clutch = 0;     // buttons: while all are held the tool is let go; none: no clutch
  bool keep_tool_pose = false;  // take the tool up where it is, rather than moving it into the hand
  DVec3 torque_lever{0.0};      // of a TorqueLever, metres in the handle's frame; zero: none
};

// The tool in the handle: where it goes when the handle moves, and what the hand then feels. While the clutch
// is held the tool stays where it is and pushes nobody; after it, it is held as it then lies in the hand, so
// that it does not jump.
class ToolGrip {
 public:
  explicit ToolGrip(const DeviceMapping& mapping);

  // Moves the handle, which must be finite. The pose is the tool's, which lies at `tool`.
  Pose follow(const DeviceState& state, const Pose& tool);

  // What a wrench on the tool about `reference`, all in the world frame, is to the hand. Torques are scaled
  // by force_scale / motion_scale, so that the hand's work is in one proportion to the tool's, whether it
  // moves or turns: a scene that makes no energy makes none at any scale.
  DeviceWrench on_hand(const Wrench& on_tool, const DVec3& reference) const;

 private:
  void take_up(const Pose& tool);

  DeviceMapping mapping_;
  Pose world_from_handle_;
  DVec3 offset_{0.0};  // of the handle by clutching, world frame
  bool held_;
};

}  // namespace palpate
