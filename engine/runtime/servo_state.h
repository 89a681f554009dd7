#pragma once

#include "engine/runtime/latency.h"

namespace palpate {

// What a servo thread measured since it was started.
struct ServoStatistics {
  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;   // ticks that ended after the next one's time
  std::uint64_t skipped = 0;  // ticks left out because their time had passed
  double rate_hz = 0.0;       // measured over the last second or so
  Latency work;               // of a tick
  Latency lateness;           // from a tick's time to its begin
};

// What the system granted of the options.
struct ServoGrants {
  int priority = 0;  // of SCHED_FIFO; 0: none
  int cpu = -1;      // -1: any
};

// What a live scene did since it went live.
struct LiveCounts {
  std::uint64_t waiting_ticks = 0;  // some near model was still being prepared
  std::uint64_t cut_ticks = 0;      // something found no room
  std::uint64_t preparations = 0;   // pairs of models made ready for the servo
  std::uint64_t searches = 0;       // from scratch beside the servo
};

struct ServoState {
  bool running = false;
  double wanted_rate_hz = 0.0;
  ServoGrants grants;
  ServoStatistics statistics;
  LiveCounts counts;
  std::uint64_t result_age = 0;  // ticks since the global search that the newest LMDs come from
};

}  // namespace palpate
