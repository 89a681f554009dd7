#pragma once

namespace palpate {

struct ServoOptions {
  static constexpr int kNoPriority = -1;
  static constexpr int kAnyCpu = -1;

  double rate_hz = 1000.0;  // ticks a second
  int priority = 0;         // of SCHED_FIFO, 1 to 99; 0: a usual one if the system allows; or kNoPriority
  int cpu = kAnyCpu;        // the only one it runs on, if the system allows
};

}  // namespace palpate
