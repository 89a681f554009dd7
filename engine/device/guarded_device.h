#pragma once

#include <memory>
#include <mutex>

#include "engine/device/device.h"
#include "engine/device/device_status.h"
#include "engine/device/hand_order.h"
#include "engine/device/safety_limits.h"
#include "engine/exchange/flag.h"
#include "engine/exchange/mailbox.h"
#include "engine/exchange/triple_slot.h"

namespace palpate {

class SimulatedPhantom;

// A device behind its safety limits, which nothing that is written can avoid. One thread at a time ticks it;
// any may give orders, which the next tick takes, and ask for the status, which is that of the last one. A
// tick allocates nothing, locks nothing and waits for nobody.
class GuardedDevice {
 public:
  explicit GuardedDevice(std::unique_ptr<Device> device);
  ~GuardedDevice();
  GuardedDevice(const GuardedDevice&) = delete;
  GuardedDevice& operator=(const GuardedDevice&) = delete;

  // From any thread.
  const DeviceInfo& info() const { return device_->info(); }
  const SafetySettings& own_settings() const { return own_; }  // those that the device came with
  DeviceStatus status();
  std::string advice(DeviceCondition condition) const { return device_->advice(condition); }
  bool calibrate() { return device_->calibrate(); }  // false: it needs nobody to do that
  void arm() { post(&SafetyLimits::arm); }
  void disarm() { post(&SafetyLimits::disarm); }
  void set_settings(const SafetySettings& settings);
  bool order_hand(HandOrder order);  // false: no simulated hand holds the device

  // Whoever ticks by itself and takes a servo along; null: a servo has to tick for itself.
  ServoHost* servo_host() { return device_->servo_host(); }

  // What no sensor sees, between two ticks; null where nothing is simulated.
  const SimulatedPhantom* simulated() const { return phantom_; }

  // Of all who would tick a device one may have it at a time. False: another has it.
  bool claim() { return !claimed_.raise(); }
  void give_up() { claimed_.lower(); }

  // The servo's, once a tick and in this order. `dt` seconds pass from one tick to the next.
  const DeviceState& read();
  // `computed`: the wrench is new; one that is not goes stale.
  void write(const DeviceWrench& wanted, bool computed, double dt);

  // The servo's last: nothing pushes the hand until the next tick, and then force fades in anew.
  void let_go();

 private:
  class Order;
  class LimitsOrder;
  class SettingsOrder;
  class HandsOrder;

  void post(void (SafetyLimits::*order)());
  void post(std::unique_ptr<Order> order);
  void take_orders();
  void publish();
  void look_beside(DeviceStatus& status);

  const std::unique_ptr<Device> device_;
  SimulatedPhantom* const phantom_;  // device_, if it is one
  const SafetySettings own_;
  SafetyLimits limits_;
  DeviceStatus now_;
  std::uint64_t computed_ = 0;

  Flag claimed_;
  Mailbox orders_;  // to the servo
  Mailbox taken_;   // back, because freeing memory is nothing for a servo
  TripleSlot<DeviceStatus> shown_;
  std::mutex asking_;  // guards the orders' side of both mailboxes and the reader's side of shown_
};

}  // namespace palpate
