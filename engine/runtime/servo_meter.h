#pragma once

#include "engine/exchange/triple_slot.h"
#include "engine/runtime/servo_state.h"

namespace palpate {

// Counts and times the ticks of a servo for one who asks meanwhile.
class ServoMeter {
 public:
  using Nanoseconds = std::int64_t;

  struct Report {
    ServoStatistics statistics;
    ServoGrants grants;
  };

  // Of the clock whose times it is given.
  static constexpr Nanoseconds kSecond = 1'000'000'000;
  static Nanoseconds now();

  // The servo's: before its first tick, and after each one.
  void begin(Nanoseconds time, Nanoseconds period, const ServoGrants& grants);
  // When the next tick is due that can still be in time.
  Nanoseconds tick(Nanoseconds due, Nanoseconds begin, Nanoseconds end);

  const Report& newest();

 private:
  void measure_rate(Nanoseconds time);

  Report report_;
  Nanoseconds period_ = 1;
  Nanoseconds rate_start_ = 0;
  std::int64_t rate_ticks_ = 0;
  TripleSlot<Report> reports_;
};

}  // namespace palpate
