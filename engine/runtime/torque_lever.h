#pragma once

#include "engine/device/device_info.h"
#include "engine/device/device_wrench.h"

namespace palpate {

// Torque for a hand whose device has motors for force alone: the handle is taken for the end of a lever, and
// what torque about its other end is felt as is the force that has it at this length. A torque along the
// lever has none. Such a force does work that turning the handle does not give back, so a loop with it may
// be less stable.
class TorqueLever {
 public:
  TorqueLever() = default;

  // `lever` from the pivot to the handle, metres in the handle's frame; zero, as any with a device that has a
  // motor for a torque, changes nothing.
  TorqueLever(const DVec3& lever, const DeviceInfo& device)
      : lever_((device.capabilities.actuated & kRotations) == 0 ? lever : DVec3(0.0)),
        most_(kShare * device.limits.max_force) {}

  // `wrench` in the base frame, the handle turned as `orientation` in it. What of the torque is left is what
  // no force stands for.
  DeviceWrench felt(const DeviceWrench& wrench, const DQuat& orientation) const {
    const DVec3 lever = orientation * lever_;
    const double squared = glm::dot(lever, lever);
    if (!(squared > 0.0)) return wrench;
    const DVec3 wanted = glm::cross(wrench.torque, lever) / squared;
    const double size = glm::length(wanted);
    const DVec3 force = size > most_ ? most_ / size * wanted : wanted;
    return {wrench.force + force, wrench.torque - glm::cross(lever, force)};
  }

 private:
  // Of what the device can: a contact's own force is to be felt beside it.
  static constexpr double kShare = 0.5;

  DVec3 lever_{0.0};
  double most_ = 0.0;  // N
};

}  // namespace palpate
