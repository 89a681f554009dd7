#include "capi/src/handles.h"
#include "capi/src/numbers.h"
#include "capi/src/structs.h"
#include "engine/device/registry.h"

namespace palpate::capi {
namespace {

constexpr double kMilliseconds = 1e3;  // in a second: the engine has slew per millisecond

// Sets what the caller has tightened; 0 keeps `own`.
void lower(double& own, double given, const char* name) {
  if (checked_not_negative(given, name) == 0.0) return;
  if (given > own) refuse_argument(name, " is looser than the device's own");
  own = given;
}

void lengthen(double& own, double given, const char* name) {
  if (checked_not_negative(given, name) == 0.0) return;
  if (given < own) refuse_argument(name, " is shorter than the device's own");
  own = given;
}

void lower_slew(double& own, double given, const char* name) {
  lower(own, checked(given, name) / kMilliseconds, name);
}

SafetySettings tightened(SafetySettings own, const plp_safety_limits& limits, int buttons) {
  if (buttons < 32 && limits.dead_man >> buttons != 0) {
    refuse_argument("limits->dead_man", " names a button that the device has not");
  }
  own.dead_man = limits.dead_man;
  lower(own.max_force, limits.max_force, "limits->max_force");
  lower(own.max_torque, limits.max_torque, "limits->max_torque");
  lower_slew(own.force_slew, limits.force_slew, "limits->force_slew");
  lower_slew(own.torque_slew, limits.torque_slew, "limits->torque_slew");
  lower(own.max_speed, limits.max_speed, "limits->max_speed");
  lower(own.max_turn_rate, limits.max_turn_rate, "limits->max_turn_rate");
  lower(own.watchdog, limits.watchdog, "limits->watchdog");
  lengthen(own.ramp_time, limits.ramp_time, "limits->ramp_time");
  lengthen(own.fault_hold, limits.fault_hold, "limits->fault_hold");
  return own;
}

HandleTable<DeviceObject>::Pin pin_device(plp_device device) {
  return device_table().pin(bits_of(device));
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

plp_result plp_device_open(const char* uri, plp_device* device) {
  return guarded([&] {
    require(device, "device is null");
    auto opened = value_or_refuse(DeviceRegistry::standard().open(uri ? uri : kDefaultDeviceUri));
    auto guarded_device = std::make_shared<GuardedDevice>(std::move(opened));
    *device = new_handle<plp_device>(device_table(),
                                     std::make_unique<DeviceObject>(DeviceObject{std::move(guarded_device)}));
  });
}

plp_result plp_device_retain(plp_device device) {
  return guarded([&] {
    const SlotTable::Outcome outcome = device_table().retain(bits_of(device));
    if (outcome == SlotTable::Outcome::kFull) refuse(ErrorCode::kLimit, "device has 65,535 references");
    require_handle(outcome == SlotTable::Outcome::kDone, "device");
  });
}

plp_result plp_device_release(plp_device device) {
  return guarded([&] { release_handle(device_table(), device, "device"); });
}

plp_result plp_device_arm(plp_device device) {
  return guarded([&] {
    const auto object = pin_device(device);
    require_handle(object, "device");
    object->device->arm();
  });
}

plp_result plp_device_disarm(plp_device device) {
  return guarded([&] {
    const auto object = pin_device(device);
    require_handle(object, "device");
    object->device->disarm();
  });
}

plp_result plp_device_calibrate(plp_device device) {
  return guarded([&] {
    const auto object = pin_device(device);
    require_handle(object, "device");
    if (object->device->calibrate()) return;
    refuse(ErrorCode::kUnsupported, object->device->info().identity.uri + " needs nobody to calibrate it");
  });
}

void plp_safety_limits_init(plp_safety_limits* limits, size_t size) {
  fill_struct(plp_safety_limits{}, limits, size);
}

plp_result plp_device_set_limits(plp_device device, const plp_safety_limits* limits) {
  return guarded([&] {
    const auto object = pin_device(device);
    require_handle(object, "device");
    GuardedDevice& guarded_device = *object->device;
    guarded_device.set_settings(tightened(guarded_device.own_settings(), read_struct(limits, "limits"),
                                          guarded_device.info().capabilities.buttons));
  });
}
