#pragma once

#include <memory>

#include "engine/device/guarded_device.h"
#include "engine/runtime/tool_grip.h"
#include "engine/runtime/torque_lever.h"
#include "engine/scene/scene.h"

namespace palpate {

// One tick of what a hand feels: read the device, move the tool, step the scene, limit the wrench, write it.
// Without a device it steps the scene. One thread at a time, but the device's own orders and status.
class HapticLoop {
 public:
  explicit HapticLoop(Scene& scene) : scene_(scene) {}
  ~HapticLoop() { detach(); }
  HapticLoop(const HapticLoop&) = delete;
  HapticLoop& operator=(const HapticLoop&) = delete;

  // From now on the tool follows `device` and the hand feels it. False, and nothing is changed, if another
  // loop has the device.
  bool attach(std::shared_ptr<GuardedDevice> device, const DeviceMapping& mapping);

  // The same with a device that is claimed already, or that this loop has; null detaches. The device before
  // is given back, so that a servo need not destroy it.
  std::shared_ptr<GuardedDevice> exchange(std::shared_ptr<GuardedDevice> device,
                                          const DeviceMapping& mapping);

  // Lets go of the hand.
  std::shared_ptr<GuardedDevice> detach() { return exchange(nullptr, {}); }

  const GuardedDevice* device() const { return device_.get(); }

  // `dt` seconds after the tick before. Throws what a step of the scene throws, after the device has had its
  // tick with the wrench before: if no new one follows, its limits let go.
  void tick(double dt);

 private:
  void move_tool(const DeviceState& state);
  DeviceWrench felt(const DQuat& handle) const;

  Scene& scene_;
  std::shared_ptr<GuardedDevice> device_;
  ToolGrip grip_{DeviceMapping{}};
  TorqueLever lever_;
  DeviceWrench wanted_;
};

}  // namespace palpate
