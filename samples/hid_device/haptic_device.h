#pragma once

#include <array>
#include <cstdint>

#include "samples/hid_device/mass.h"
#include "samples/hid_device/report.h"

namespace palpate::hid_device {

// The firmware of a haptic device, but for its motors: what it does with a host's reports, and when it lets
// go. It has no clock and no threads; whoever owns the loop steps it.
class HapticDevice {
 public:
  explicit HapticDevice(const Features& features = {});

  // The host's. False: the report is refused, and nothing changes.
  bool take_wrench(Bytes report);
  bool take_command(Bytes report);
  std::array<std::uint8_t, 64> features() const { return report_of(features_); }

  // What happens at the device itself.
  void set_buttons(std::uint16_t buttons) { buttons_ = buttons; }
  void hold_dead_man(bool held) { dead_man_ = held; }
  void press_emergency_stop(bool pressed) { emergency_ = pressed; }
  void set_temperature(std::uint8_t temperature) { temperature_ = temperature; }  // 255: too hot
  Mass& mass() { return mass_; }

  // A sample's time passes. The report is what the host is told then.
  std::array<std::uint8_t, 64> step();

  // What the motors give now.
  const Vector& force() const { return force_; }
  const Vector& torque() const { return torque_; }
  bool armed() const { return armed_; }
  std::uint16_t sequence() const { return sequence_; }
  double time() const { return time_; }

  // Where the sequence goes on, to see it wrap.
  void set_sequence(std::uint16_t sequence) { sequence_ = sequence; }

 private:
  bool may_push() const;
  bool is_hot() const { return temperature_ == 255; }
  void push(double dt);
  std::uint8_t flags() const;

  const Features features_;
  Mass mass_;
  WrenchOrder order_;
  double expires_ = 0.0;  // s: when the order dies
  double watchdog_;       // s
  double time_ = 0.0;     // s
  double ramped_ = 0.0;   // s since force began to fade in
  double gain_ = 0.0;
  Vector force_{};
  Vector torque_{};
  std::uint16_t sequence_ = 0;
  std::uint16_t buttons_ = 0;
  std::uint8_t temperature_ = 0;
  bool calibrated_;
  bool armed_ = false;
  bool tripped_ = false;
  bool saturated_ = false;
  bool dead_man_ = true;
  bool emergency_ = false;
};

}  // namespace palpate::hid_device
