#include "engine/runtime/haptic_loop.h"

#include <utility>

#include "engine/device/finite.h"

namespace palpate {
namespace {

// What the hand feels of the scene's stiffness is scaled by both.
double stiffness_at_tool(const GuardedDevice* device, const DeviceMapping& mapping) {
  const double felt = mapping.motion_scale * mapping.force_scale;
  return device && felt > 0.0 ? device->info().limits.max_stiffness / felt : 0.0;
}

}  // namespace

bool HapticLoop::attach(std::shared_ptr<GuardedDevice> device, const DeviceMapping& mapping) {
  if (device != device_ && !device->claim()) return false;
  exchange(std::move(device), mapping);
  return true;
}

std::shared_ptr<GuardedDevice> HapticLoop::exchange(std::shared_ptr<GuardedDevice> device,
                                                    const DeviceMapping& mapping) {
  grip_ = ToolGrip(mapping);
  lever_ = device ? TorqueLever(mapping.torque_lever, device->info()) : TorqueLever();
  scene_.set_device_stiffness(stiffness_at_tool(device.get(), mapping));
  wanted_ = {};
  if (device_ && device != device_) {
    device_->let_go();
    device_->give_up();
  }
  return std::exchange(device_, std::move(device));
}

void HapticLoop::tick(double dt) {
  if (!device_) return scene_.step(dt);
  const DeviceState& state = device_->read();
  move_tool(state);
  try {
    scene_.step(dt);
  } catch (...) {
    device_->write(wanted_, false, dt);
    throw;
  }
  wanted_ = felt(state.tool.orientation);
  device_->write(wanted_, true, dt);
}

// A pose that is none moves nothing; the limits see it, too.
void HapticLoop::move_tool(const DeviceState& state) {
  const Body* tool = scene_.find(scene_.tool());
  if (tool && is_finite(state)) scene_.set_pose(scene_.tool(), grip_.follow(state, tool->pose()));
}

DeviceWrench HapticLoop::felt(const DQuat& handle) const {
  const Body* tool = scene_.find(scene_.tool());
  if (!tool) return {};
  const DVec3 reference = tool->pose() * tool->options().reference_point;
  return lever_.felt(grip_.on_hand(scene_.contacts().wrench, reference), handle);
}

}  // namespace palpate
