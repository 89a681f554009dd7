#include "samples/cli/comparison.h"

#include <algorithm>
#include <cmath>

#include "samples/cli/percentile.h"
#include "samples/cli/set_matching.h"

namespace palpate::cli {
namespace {

double distance(const double (&one)[3], const double (&other)[3]) {
  return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

double rms(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  return values.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace

void Comparison::add(const plp_contacts& found, const plp_contacts& complete) {
  counts_.sets += complete.set_count;
  const std::size_t matched = SetMatching(found, complete, reach_).pairs();
  counts_.missed += complete.set_count - matched;
  counts_.spurious += found.set_count - matched;
  force_errors_.push_back(distance(found.wrench.force, complete.wrench.force) / force_);
  torque_errors_.push_back(distance(found.wrench.torque, complete.wrench.torque) / torque_);
}

ComparisonSummary Comparison::summary() const {
  ComparisonSummary summary = counts_;
  std::vector<double> ascending = force_errors_;
  std::sort(ascending.begin(), ascending.end());
  summary.force_error_rms = rms(force_errors_);
  summary.force_error_p999 = percentile(ascending, 0.999);
  summary.force_error_max = ascending.back();
  summary.torque_error_rms = rms(torque_errors_);
  summary.torque_error_max = *std::max_element(torque_errors_.begin(), torque_errors_.end());
  return summary;
}

}  // namespace palpate::cli
