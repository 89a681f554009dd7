// A soak of seconds; tests/soak/run.sh has one of an hour.
#include "tests/soak/soak.h"

#include <cstdio>

#include <gtest/gtest.h>

namespace palpate::test {
namespace {

TEST(Soak, LeavesMemoryFlatAndForcesAsTheyWere) {
  SoakOptions options;
  options.pairs = {{"organic_2200", "torus"}};
  options.seconds = 1.0;
  options.poses = 60;
  std::printf("seed %llu\n", static_cast<unsigned long long>(options.seed));
  const SoakOutcome outcome = soak(options, [](const SoakProgress&) {});
  std::printf("%llu ticks\n", static_cast<unsigned long long>(outcome.end.ticks));
  EXPECT_GT(outcome.touching_ticks, outcome.end.ticks / 2);
  EXPECT_EQ(outcome.wrong, std::vector<std::string>());
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LE(outcome.end.resident_bytes, outcome.warm.resident_bytes + (2 << 20));
#endif
}

}  // namespace
}  // namespace palpate::test
