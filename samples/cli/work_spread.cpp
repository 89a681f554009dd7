#include "samples/cli/work_spread.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "samples/cli/percentile.h"

namespace palpate::cli {
namespace {

struct Count {
  const char* name;
  std::uint64_t plp_work::*of;
};

constexpr Count kCounts[] = {{"node_pairs", &plp_work::node_pairs},
                             {"triangle_pairs", &plp_work::triangle_pairs},
                             {"descents", &plp_work::descents},
                             {"descent_steps", &plp_work::descent_steps},
                             {"front_entries", &plp_work::front_entries},
                             {"front_expired", &plp_work::front_expired},
                             {"age_ticks", &plp_work::age}};

}  // namespace

Spread WorkSpread::spread_of(std::uint64_t plp_work::*count) const {
  std::vector<double> ascending;
  for (const plp_work& work : works_) ascending.push_back(static_cast<double>(work.*count));
  std::sort(ascending.begin(), ascending.end());
  const double sum = std::accumulate(ascending.begin(), ascending.end(), 0.0);
  return {sum / static_cast<double>(ascending.size()), percentile(ascending, 0.5),
          percentile(ascending, 0.99), ascending.back()};
}

void WorkSpread::write(JsonWriter& json) const {
  write(json, "work", &Spread::mean);
  write(json, "work_p50", &Spread::p50);
  write(json, "work_p99", &Spread::p99);
  write(json, "work_max", &Spread::max);
}

void WorkSpread::write(JsonWriter& json, const char* name, double Spread::*statistic) const {
  json.key(name).open_object();
  for (const Count& count : kCounts) json.field(count.name, spread_of(count.of).*statistic);
  json.close();
}

void WorkSpread::print() const {
  std::printf("%-28s %12s %12s %12s %12s\n", "work of a tick", "mean", "p50", "p99", "max");
  for (const Count& count : kCounts) {
    const Spread spread = spread_of(count.of);
    std::printf("%-28s %12.2f %12.0f %12.0f %12.0f\n", count.name, spread.mean, spread.p50, spread.p99,
                spread.max);
  }
}

}  // namespace palpate::cli
