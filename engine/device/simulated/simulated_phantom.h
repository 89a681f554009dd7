#pragma once

#include <cstdint>
#include <memory>

#include "engine/device/device.h"
#include "engine/device/simulated/encoder.h"
#include "engine/device/simulated/hand_impedance.h"
#include "engine/device/simulated/hand_motion.h"
#include "engine/device/simulated/handle_body.h"
#include "engine/device/simulated/phantom_spec.h"
#include "engine/device/simulated/sample_delay.h"

namespace palpate {

// A PHANToM in a hand, without hardware. Time passes only in `step`: called with constant steps it is
// deterministic, called with elapsed time it runs in real time. A sample is taken at the end of every step;
// the last wrench is held meanwhile.
class SimulatedPhantom final : public Device {
 public:
  // `delay` is in samples, 0 to SampleDelay::kLongest.
  explicit SimulatedPhantom(const PhantomSpec& spec, int delay = 0);

  const DeviceInfo& info() const override { return info_; }
  DeviceState read() override { return samples_.delayed(); }
  void write(const DeviceWrench& wrench) override;

  // A step that is not positive does nothing. No more than 0.1 s passes in one: the rest is a pause, such as
  // a debugger's. Ten milliseconds after the last write the actuators let go.
  void step(double dt) override;

  void set_grip(Grip grip) { hand_ = impedance_of(grip); }
  void set_hand(const HandImpedance& hand) { hand_ = hand; }

  // What the hand intends from now on. Without a motion it holds still at the middle of the workspace. The
  // motion before is given back, so that a servo need not destroy it.
  std::shared_ptr<const HandMotion> set_motion(std::shared_ptr<const HandMotion> motion);

  // Moves the handle at once, and at rest, to where the hand intends to be now.
  void place_in_hand();

  // Bit i holds button i down; seen by the next sample.
  void set_buttons(std::uint32_t buttons) { buttons_ = buttons; }

  // What no sensor sees.
  const RigidMotion& true_motion() const { return body_.motion(); }
  const DeviceWrench& applied() const { return applied_; }  // after saturation
  const EnergyLedger& energy() const { return body_.energy(); }

 private:
  HandPose intended(double time) const;
  RigidMotion hand_target(double dt) const;
  DeviceState current_state(const RigidMotion& tool) const;

  DeviceInfo info_;
  HandleBody body_;
  Encoder encoder_;
  SampleDelay samples_;
  HandImpedance hand_ = impedance_of(Grip::kLight);
  std::shared_ptr<const HandMotion> motion_;
  DeviceWrench applied_;
  double time_ = 0.0;
  double motion_began_ = 0.0;
  double written_ = 0.0;  // time of the last write
  std::uint64_t sequence_ = 0;
  std::uint32_t buttons_ = 0;
};

}  // namespace palpate
