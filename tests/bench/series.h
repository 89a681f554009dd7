#pragma once

#include <cstddef>
#include <vector>

namespace palpate::bench {

// The values of one quantity over a run.
class Series {
 public:
  void add(double value) { values_.push_back(value); }
  std::size_t count() const { return values_.size(); }

  // The least value that `share` of all do not exceed. There must be values.
  double percentile(double share) const;
  double root_mean_square() const;

 private:
  std::vector<double> values_;
};

}  // namespace palpate::bench
