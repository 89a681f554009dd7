#include "engine/runtime/latency.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/random_poses.h"

namespace palpate {
namespace {

TEST(Latency, OfNothingIsZero) {
  const Latency latency;
  EXPECT_EQ(latency.percentile_us(0.99), 0.0);
  EXPECT_EQ(latency.max_us(), 0.0);
}

// Never too short, and no more than an eighth too long.
TEST(Latency, PercentilesAreThoseOfAllTimes) {
  constexpr std::uint64_t kSeed = 4;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  Random random(kSeed);
  Latency latency;
  std::vector<double> times;
  for (int i = 0; i < 20'000; ++i) {
    const auto time = static_cast<std::uint64_t>(std::exp2(random.uniform(0.0, 36.0)));
    latency.add(time);
    times.push_back(1e-3 * static_cast<double>(time));
  }
  std::sort(times.begin(), times.end());
  for (const double share : {0.001, 0.01, 0.25, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const double exact =
        times[static_cast<std::size_t>(std::ceil(share * static_cast<double>(times.size()))) - 1];
    EXPECT_GE(latency.percentile_us(share), exact) << share;
    EXPECT_LE(latency.percentile_us(share), 1.126 * exact) << share;
  }
  EXPECT_EQ(latency.max_us(), times.back());
  EXPECT_EQ(latency.count(), times.size());
}

TEST(Latency, TakesAnyTime) {
  Latency latency;
  latency.add(0);
  latency.add(UINT64_MAX);
  EXPECT_EQ(latency.percentile_us(0.5), 0.0);
  EXPECT_GT(latency.percentile_us(1.0), 3.6e9);
}

}  // namespace
}  // namespace palpate
