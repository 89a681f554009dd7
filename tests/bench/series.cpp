#include "tests/bench/series.h"

#include <algorithm>
#include <cmath>

namespace palpate::bench {

double Series::percentile(double share) const {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values_.size())));
  std::vector<double> values = values_;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double Series::root_mean_square() const {
  double sum = 0.0;
  for (double value : values_) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values_.size()));
}

}  // namespace palpate::bench
