#pragma once

#include <vector>

#include "palpate/palpate.h"
#include "samples/cli/json_writer.h"

namespace palpate::cli {

// How one count of a tick's work spreads over a run.
struct Spread {
  double mean;
  double p50;
  double p99;
  double max;
};

// The work of each tick of a run, which has at least one.
class WorkSpread {
 public:
  void add(const plp_work& work) { works_.push_back(work); }

  Spread spread_of(std::uint64_t plp_work::*count) const;
  void write(JsonWriter& json) const;  // "work" for the means, "work_p50", "work_p99" and "work_max"
  void print() const;

 private:
  void write(JsonWriter& json, const char* name, double Spread::*statistic) const;

  std::vector<plp_work> works_;
};

}  // namespace palpate::cli
