#pragma once

#include "tests/stress/families.h"
#include "tests/stress/reference.h"

namespace palpate::stress {

// What the searches made of cases.
struct SearchOutcome {
  int cases = 0;
  int poses = 0;
  Verdict global;      // searched from scratch
  Verdict certified;   // kept by a kinetic front along a motion that ends at the pose
  Verdict descent;     // followed along it; what it misses does not count
  int most_steps = 0;  // of a descent
  int cut_short = 0;   // descents that took more steps than the engine lets them take at once
  int endless = 0;     // descents that did not end at all
  int descents = 0;

  void add(const SearchOutcome& other);
  int faults() const;
};

// Runs one case; throws std::runtime_error if its models cannot be made.
SearchOutcome stress_search(const Case& c, Random& random);

}  // namespace palpate::stress
