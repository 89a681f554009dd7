#include "samples/cli/tick.h"

#include <algorithm>

#include "samples/cli/numbers.h"
#include "samples/cli/percentile.h"

namespace palpate::cli {
namespace {

void write_row(const Tick& tick, std::ostream& out) {
  out << exact_text(tick.seconds) << ',' << tick.lmds << ',' << exact_text(tick.min_distance);
  for (const double component : tick.wrench.force) out << ',' << exact_text(component);
  for (const double component : tick.wrench.torque) out << ',' << exact_text(component);
  out << ',' << exact_text(tick.local_us) << ',' << exact_text(tick.work.global_us) << ','
      << tick.work.triangle_pairs << ',' << tick.work.age << '\n';
}

}  // namespace

void write_csv(const std::vector<Tick>& ticks, std::ostream& out) {
  out << "t,lmds,min_distance,fx,fy,fz,tx,ty,tz,local_us,global_us,pairs,age_ticks\n";
  for (const Tick& tick : ticks) write_row(tick, out);
}

RunSummary summary_of(const std::vector<Tick>& ticks) {
  RunSummary summary;
  summary.ticks = ticks.size();
  std::vector<double> local_us;
  for (const Tick& tick : ticks) {
    summary.ticks_in_contact += tick.lmds > 0;
    summary.ticks_overlapping += tick.overlap;
    summary.most_lmds = std::max(summary.most_lmds, tick.lmds);
    local_us.push_back(tick.local_us);
    summary.work.add(tick.work);
  }
  std::sort(local_us.begin(), local_us.end());
  summary.local_us_p50 = percentile(local_us, 0.5);
  summary.local_us_p99 = percentile(local_us, 0.99);
  summary.local_us_p999 = percentile(local_us, 0.999);
  summary.local_us_max = local_us.back();
  return summary;
}

}  // namespace palpate::cli
