// What is skipped because the tool cannot have come near is never within its reach.
#include <gtest/gtest.h>

#include <vector>

#include "engine/scene/tool_reach.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 41;
constexpr int kTicks = 5000;
constexpr double kCutoff = 0.02;

struct Far {
  Sphere sphere;
  double until = 0.0;
};

std::vector<Far> crowd(const DVec3& origin, Random& random) {
  std::vector<Far> bodies(200);
  for (Far& far : bodies) far.sphere = {origin + 2.0 * random.direction(), random.uniform(0.01, 0.5)};
  return bodies;
}

// Looks at those that may be near, as a scene does; returns how many.
int look(const ToolReach& reach, std::vector<Far>& bodies) {
  int looked = 0;
  for (Far& far : bodies) {
    if (far.until > reach.way()) continue;
    far.until = reach.far_until(far.sphere);
    ++looked;
  }
  return looked;
}

class ToolReachTest : public testing::TestWithParam<double> {};

TEST_P(ToolReachTest, NothingWithinReachIsSkipped) {
  const DVec3 origin(GetParam());
  Random random(kSeed);
  std::vector<Far> bodies = crowd(origin, random);
  ToolReach reach;
  Sphere tool{origin, 0.1};
  DVec3 direction;
  int looked = 0, near = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    if (tick % 500 == 0) direction = random.direction();
    tool.centre += (tick % 499 == 0 ? 0.5 : tick % 7 == 0 ? 1e-12 : 3e-3) * direction;
    if (glm::length(tool.centre - origin) > 2.0) tool.centre = origin;
    if (!reach.follow(1, tool, kCutoff))
      for (Far& far : bodies) far.until = 0.0;
    looked += look(reach, bodies);
    for (const Far& far : bodies) {
      if (!within_reach(far.sphere, tool, kCutoff)) continue;
      ++near;
      ASSERT_EQ(far.until, 0.0) << "seed " << kSeed << ", tick " << tick;
    }
  }
  EXPECT_GT(near, 0);
  EXPECT_LT(looked - near, kTicks * 200 / 20) << "far bodies looked at";
}

INSTANTIATE_TEST_SUITE_P(AwayFromTheOrigin, ToolReachTest, testing::Values(0.0, 1e3, 1e6));

TEST(ToolReach, StartsAfreshForAnotherToolOrCutoff) {
  ToolReach reach;
  const Sphere tool{DVec3(0.0), 0.1};
  EXPECT_FALSE(reach.follow(1, tool, kCutoff));
  EXPECT_TRUE(reach.follow(1, tool, kCutoff));
  EXPECT_FALSE(reach.follow(2, tool, kCutoff));
  EXPECT_FALSE(reach.follow(2, tool, 2 * kCutoff));
  EXPECT_FALSE(reach.follow(2, {DVec3(0.0), 0.2}, 2 * kCutoff));
  EXPECT_FALSE(reach.follow(2, {DVec3(NAN), 0.2}, 2 * kCutoff));
}

}  // namespace
}  // namespace palpate
