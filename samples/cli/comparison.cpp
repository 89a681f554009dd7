#include "samples/cli/comparison.h"

#include <algorithm>
#include <cmath>

#include "samples/cli/contacts.h"
#include "samples/cli/percentile.h"

namespace palpate::cli {
namespace {

double distance(const double (&one)[3], const double (&other)[3]) {
  return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

bool same_place(const plp_lmd& one, const plp_lmd& other, double reach) {
  return distance(one.point_a, other.point_a) <= reach && distance(one.point_b, other.point_b) <= reach;
}

double rms(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  return values.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace

void Comparison::add(const plp_contacts& found, const plp_contacts& complete) {
  counts_.sets += complete.set_count;
  counts_.missed += unmatched(complete, found);
  counts_.spurious += unmatched(found, complete);
  force_errors_.push_back(distance(found.wrench.force, complete.wrench.force) / force_);
  torque_errors_.push_back(distance(found.wrench.torque, complete.wrench.torque) / torque_);
}

// A set is another one if they have a point in common: a plateau may be represented by others of its points.
std::size_t Comparison::unmatched(const plp_contacts& sets, const plp_contacts& among) const {
  std::size_t count = 0;
  for (std::size_t begin = 0, end; begin < sets.lmd_count; begin = end) {
    bool matched = false;
    for (end = begin; end < sets.lmd_count && lmd_at(sets, end).set == lmd_at(sets, begin).set; ++end)
      for (std::size_t k = 0; k < among.lmd_count && !matched; ++k)
        matched = same_place(lmd_at(sets, end), lmd_at(among, k), reach_);
    count += matched ? 0 : 1;
  }
  return count;
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
