#pragma once

#include <cstddef>
#include <vector>

#include "palpate/palpate.h"

namespace palpate::cli {

// How far outcomes are from the complete ones of the same poses.
struct ComparisonSummary {
  std::size_t sets = 0;      // of the complete outcomes
  std::size_t missed = 0;    // of these: no set of the outcome is one of them
  std::size_t spurious = 0;  // sets of the outcomes that are none of the complete ones, or one a second time
  double force_error_rms = 0.0;  // of the wrench, in stiffness × cutoff
  double force_error_p999 = 0.0;
  double force_error_max = 0.0;
  double torque_error_rms = 0.0;  // in stiffness × cutoff × half the tool's diagonal
  double torque_error_max = 0.0;
};

class Comparison {
 public:
  // Newtons and newton-metres to which errors are relative; points count as one within `reach` metres.
  Comparison(double force, double torque, double reach) : force_(force), torque_(torque), reach_(reach) {}

  void add(const plp_contacts& found, const plp_contacts& complete);
  ComparisonSummary summary() const;

 private:
  double force_;
  double torque_;
  double reach_;
  ComparisonSummary counts_;
  std::vector<double> force_errors_;
  std::vector<double> torque_errors_;
};

}  // namespace palpate::cli
