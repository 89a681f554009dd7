#pragma once

#include <optional>
#include <string>

#include "engine/device/device_info.h"
#include "engine/device/device_state.h"
#include "engine/device/device_wrench.h"
#include "engine/device/servo_host.h"

namespace palpate {

// An open haptic device. Whoever owns the servo loop calls, once a tick and from one thread: read, engage,
// write, step. These allocate nothing, lock nothing and do not throw.
class Device {
 public:
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  virtual const DeviceInfo& info() const = 0;

  // The newest sample.
  virtual DeviceState read() = 0;

  // What the actuators hold until the next call, or until the device's own watchdog sets them to zero. Safety
  // limits come before: a device saturates, but does not judge.
  virtual void write(const DeviceWrench& wrench) = 0;

  // Before a write: whether force may follow. A device with amplifiers of its own turns them on and off by
  // it.
  virtual void engage(bool /*engaged*/) {}

  // The newest sample for any thread, beside whoever ticks; none where samples come with ticks alone.
  virtual std::optional<DeviceState> glance() { return std::nullopt; }

  // Whose thread owns the loop, if it is not for the caller to make one.
  virtual ServoHost* servo_host() { return nullptr; }

  // From any thread: the handle is where calibration wants it. False: the device calibrates itself, or never.
  virtual bool calibrate() { return false; }

  // What its user can do about a condition of it, in one sentence.
  virtual std::string advice(DeviceCondition condition) const { return std::string(advice_on(condition)); }

  // Lets `dt` seconds pass for a device whose time does not pass by itself; hardware has nothing to do.
  virtual void step(double dt) = 0;

 protected:
  Device() = default;
};

}  // namespace palpate
