#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

#include "palpate/palpate.h"
#include "samples/cli/work_spread.h"

namespace palpate::cli {

// What one tick of a run found and cost.
struct Tick {
  double seconds;
  std::size_t lmds;  // sets: a plateau counts once
  double min_distance;
  plp_wrench wrench;
  double local_us;  // all that the tick computed up to its wrench
  plp_work work;
  bool overlap;
};

void write_csv(const std::vector<Tick>& ticks, std::ostream& out);

// A run in a few numbers.
struct RunSummary {
  std::size_t ticks = 0;
  std::size_t ticks_in_contact = 0;
  std::size_t ticks_overlapping = 0;
  std::size_t most_lmds = 0;
  double local_us_p50 = 0.0;
  double local_us_p99 = 0.0;
  double local_us_p999 = 0.0;
  double local_us_max = 0.0;
  WorkSpread work;
};

RunSummary summary_of(const std::vector<Tick>& ticks);  // of at least one

}  // namespace palpate::cli
