#pragma once

#include <cstdint>
#include <random>

#include "engine/snch/lmd_search.h"

namespace palpate {

// Reproducible random numbers: the seed names the run.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
  }
  std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(generator_() % count); }
  DVec3 direction();
  DMat3 rotation();

 private:
  std::mt19937_64 generator_;
};

// A pose of `b` in `a`'s frame at which they are about `gap` metres apart, measured along a random direction
// through a random vertex of each; a negative gap makes them overlap. Far parts may be nearer.
Pose place_near(const Model& a, const Model& b, double gap, Random& random);

}  // namespace palpate
