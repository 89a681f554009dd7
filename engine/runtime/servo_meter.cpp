#include "engine/runtime/servo_meter.h"

#include <time.h>

#include <algorithm>

namespace palpate {

ServoMeter::Nanoseconds ServoMeter::now() {
  timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * kSecond + time.tv_nsec;
}

void ServoMeter::begin(Nanoseconds time, Nanoseconds period, const ServoGrants& grants) {
  report_.grants = grants;
  period_ = period;
  rate_start_ = time;
}

ServoMeter::Nanoseconds ServoMeter::tick(Nanoseconds due, Nanoseconds begin, Nanoseconds end) {
  ServoStatistics& statistics = report_.statistics;
  ++statistics.ticks;
  statistics.lateness.add(static_cast<std::uint64_t>(std::max<Nanoseconds>(0, begin - due)));
  statistics.work.add(static_cast<std::uint64_t>(end - begin));
  measure_rate(end);
  due += period_;
  if (end > due) {
    const Nanoseconds passed = (end - due) / period_ + 1;
    ++statistics.missed;
    statistics.skipped += static_cast<std::uint64_t>(passed);
    due += passed * period_;
  }
  reports_.back() = report_;
  reports_.publish();
  return due;
}

// About once a second.
void ServoMeter::measure_rate(Nanoseconds time) {
  double& rate_hz = report_.statistics.rate_hz;
  ++rate_ticks_;
  const Nanoseconds passed = time - rate_start_;
  if (passed <= 0 || (rate_hz > 0.0 && passed < kSecond)) return;
  rate_hz = static_cast<double>(rate_ticks_ * kSecond) / static_cast<double>(passed);
  if (passed < kSecond) return;
  rate_ticks_ = 0;
  rate_start_ = time;
}

const ServoMeter::Report& ServoMeter::newest() {
  reports_.fetch();
  return reports_.front();
}

}  // namespace palpate
