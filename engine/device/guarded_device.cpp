#include "engine/device/guarded_device.h"

#include <utility>

#include "engine/device/simulated/simulated_phantom.h"

namespace palpate {
namespace {

// The part of a vector for whose axes there are motors; `first` is the bit of x.
DVec3 actuated(const DVec3& wanted, DegreesOfFreedom degrees, int first) {
  DVec3 kept(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    if (degrees >> (first + axis) & 1) kept[axis] = wanted[axis];
  }
  return kept;
}

DeviceWrench actuated(const DeviceWrench& wanted, DegreesOfFreedom degrees) {
  return {actuated(wanted.force, degrees, 0), actuated(wanted.torque, degrees, 3)};
}

void delete_all(Letter* letter) {
  while (letter) delete std::exchange(letter, letter->next());
}

}  // namespace

// Carried out by the servo, destroyed by the others.
class GuardedDevice::Order : public Letter {
 public:
  virtual void carry_out(GuardedDevice& device) = 0;
};

class GuardedDevice::LimitsOrder final : public Order {
 public:
  explicit LimitsOrder(void (SafetyLimits::*order)()) : order_(order) {}
  void carry_out(GuardedDevice& device) override { (device.limits_.*order_)(); }

 private:
  void (SafetyLimits::*order_)();
};

class GuardedDevice::SettingsOrder final : public Order {
 public:
  explicit SettingsOrder(const SafetySettings& settings) : settings_(settings) {}
  void carry_out(GuardedDevice& device) override { device.limits_.set_settings(settings_); }

 private:
  SafetySettings settings_;
};

class GuardedDevice::HandsOrder final : public Order {
 public:
  explicit HandsOrder(HandOrder order) : order_(std::move(order)) {}

  void carry_out(GuardedDevice& device) override {
    SimulatedPhantom& phantom = *device.phantom_;
    if (order_.impedance) phantom.set_hand(*order_.impedance);
    if (order_.motion) order_.motion = phantom.set_motion(std::move(order_.motion));
    if (order_.buttons) phantom.set_buttons(*order_.buttons);
    if (order_.place) phantom.place_in_hand();
  }

 private:
  HandOrder order_;
};

GuardedDevice::GuardedDevice(std::unique_ptr<Device> device)
    : device_(std::move(device)),
      phantom_(dynamic_cast<SimulatedPhantom*>(device_.get())),
      own_(SafetySettings::for_device(device_->info().limits)),
      limits_(own_) {
  now_.state = device_->read();
  publish();
}

GuardedDevice::~GuardedDevice() {
  device_->engage(false);
  device_->write({});
  delete_all(orders_.take());
  delete_all(taken_.take());
}

DeviceStatus GuardedDevice::status() {
  const std::lock_guard lock(asking_);
  shown_.fetch();
  DeviceStatus status = shown_.front();
  look_beside(status);
  return status;
}

// A device that nobody ticks, for its scene or at all, is shown as it is now.
void GuardedDevice::look_beside(DeviceStatus& status) {
  const std::optional<DeviceState> now = device_->glance();
  if (!now) return;
  if (!claimed_.raised()) status.state = *now;
  if (!is_fault(now->condition)) return;
  status.state.condition = now->condition;
  status.applied = {};
  status.safety.state = SafetyState::kFault;
  status.safety.gain = 0.0;
}

void GuardedDevice::set_settings(const SafetySettings& settings) {
  post(std::make_unique<SettingsOrder>(settings));
}

bool GuardedDevice::order_hand(HandOrder order) {
  if (phantom_) post(std::make_unique<HandsOrder>(std::move(order)));
  return phantom_ != nullptr;
}

void GuardedDevice::post(void (SafetyLimits::*order)()) {
  post(std::make_unique<LimitsOrder>(order));
}

void GuardedDevice::post(std::unique_ptr<Order> order) {
  const std::lock_guard lock(asking_);
  delete_all(taken_.take());
  orders_.post(order.release());
}

const DeviceState& GuardedDevice::read() {
  take_orders();
  now_.state = device_->read();
  return now_.state;
}

void GuardedDevice::write(const DeviceWrench& wanted, bool computed, double dt) {
  computed_ += computed ? 1 : 0;
  const DeviceWrench possible = actuated(wanted, info().capabilities.actuated);
  now_.wanted = wanted;
  now_.unactuated = possible.force != wanted.force || possible.torque != wanted.torque;
  now_.applied = limits_.apply({possible, computed_}, now_.state, dt);
  device_->engage(limits_.is_engaged());
  device_->write(now_.applied);
  device_->step(dt);
  ++now_.ticks;
  publish();
}

void GuardedDevice::let_go() {
  limits_.restart();
  now_.wanted = now_.applied = {};
  now_.unactuated = false;
  device_->engage(false);
  device_->write({});
  publish();
}

void GuardedDevice::take_orders() {
  for (Letter* letter = orders_.take(); letter;) {
    auto* const order = static_cast<Order*>(letter);
    letter = letter->next();
    order->carry_out(*this);
    taken_.post(order);
  }
}

void GuardedDevice::publish() {
  now_.safety = limits_.report();
  shown_.back() = now_;
  shown_.publish();
}

}  // namespace palpate
