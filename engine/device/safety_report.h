#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate {

enum class SafetyState : std::uint8_t {
  kDisarmed,  // no force: not asked to arm, not calibrated, or the dead-man switch let go
  kRamping,   // force fades in
  kArmed,
  kFault,  // no force until the cause has been away for a while
};

// Everything that can change a wrench; but for the last, in the order in which it is looked at.
enum class Limiter : std::uint8_t {
  kLongTick,         // time stood still, as at a debugger's breakpoint: back to the ramp
  kNonFiniteWrench,  // fault
  kNonFinitePose,    // fault
  kPoseJump,         // fault: faster than a hand
  kStaleServo,       // fault: no new wrench
  kStalePose,        // fault: no new sample
  kForceClamp,
  kTorqueClamp,
  kForceSlew,
  kTorqueSlew,
  kRamp,
  kDevice,  // fault: the device itself reports one
};
constexpr std::size_t kLimiters = static_cast<std::size_t>(Limiter::kDevice) + 1;

// What the limiters did.
struct SafetyReport {
  SafetyState state = SafetyState::kDisarmed;
  double gain = 0.0;                             // of the ramp, 0 to 1
  std::array<bool, kLimiters> acting{};          // in the last tick
  std::array<std::uint64_t, kLimiters> ticks{};  // in how many ticks each has acted

  bool is_acting(Limiter limiter) const { return acting[static_cast<std::size_t>(limiter)]; }
  std::uint64_t ticks_of(Limiter limiter) const { return ticks[static_cast<std::size_t>(limiter)]; }
};

}  // namespace palpate
