#pragma once

#include <cstdint>

#include "engine/device/device_state.h"
#include "engine/device/device_wrench.h"
#include "engine/device/freshness.h"
#include "engine/device/safety_report.h"
#include "engine/device/safety_settings.h"

namespace palpate {

// The last that a wrench passes before the hardware. It has no clock: the same inputs give the same bits.
// A device that is not written at all must let go by itself; this sees a servo that hangs only while whoever
// drives the device still ticks. A fault ends by itself, softly, once its cause is gone: who wants it to last
// disarms. One thread at a time.
class SafetyLimits {
 public:
  // What the servo asks for; `sequence` grows with every wrench that is computed.
  struct Command {
    DeviceWrench wrench;
    std::uint64_t sequence = 0;
  };

  explicit SafetyLimits(const SafetySettings& settings) : settings_(settings) {}

  const SafetySettings& settings() const { return settings_; }
  void set_settings(const SafetySettings& settings) { settings_ = settings; }

  void arm() { wanted_ = true; }
  void disarm() { wanted_ = false; }

  // After a time in which nothing was written, however long: what was seen before it is no measure, and force
  // fades in anew. Whether to arm, and the counts, stay.
  void restart();

  // The wrench to write, `dt` seconds after the call before.
  DeviceWrench apply(const Command& command, const DeviceState& state, double dt);

  const SafetyReport& report() const { return report_; }

  // Whether force may be given.
  bool is_engaged() const {
    return report_.state == SafetyState::kRamping || report_.state == SafetyState::kArmed;
  }

 private:
  bool find_faults(const Command& command, const DeviceState& state, double dt);
  bool jumped(const DeviceState& state) const;
  void advance_state(const DeviceState& state, bool faulty, double dt);
  void advance_ramp(double dt);
  void enter(SafetyState state);
  bool may_engage(const DeviceState& state) const;
  DVec3 shaped(const DVec3& wanted, const DVec3& last, double limit, double slew, Limiter clamp,
               Limiter slewed, double dt);
  bool note(Limiter limiter, bool acting);

  SafetySettings settings_;
  SafetyReport report_;
  DeviceWrench last_;  // before the ramp
  Freshness servo_;
  Freshness pose_;
  DeviceState previous_;  // the newest finite sample before this tick
  double clean_ = 0.0;    // seconds without a fault
  double ramped_ = 0.0;   // seconds on the ramp
  bool wanted_ = false;   // to be armed
  bool has_previous_ = false;
};

}  // namespace palpate
