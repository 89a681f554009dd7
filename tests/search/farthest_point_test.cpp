// The wide search for the farthest point is that of a loop, on every instruction set, and a cone around
// directions holds them.
#include "engine/snch/farthest_point.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 6007;

class FarthestPointTest : public testing::Test {
 protected:
  ~FarthestPointTest() override { hwy::SetSupportedTargetsForTest(0); }

  PointList directions(std::size_t count, double spread) {
    const DVec3 axis = random_.direction();
    PointList list;
    for (std::size_t i = 0; i < count; ++i)
      list.push_back(Vec3(glm::normalize(axis + spread * random_.direction())));
    return list;
  }

  Random random_{kSeed};
};

FarthestPoint one_by_one(const PointList& points, std::size_t first, std::size_t end, const Vec3& from) {
  FarthestPoint farthest{first, -1.0f};
  for (std::size_t i = first; i < end; ++i) {
    const Vec3 way = points[i] - from;
    const float squared = way.x * way.x + way.y * way.y + way.z * way.z;
    if (squared > farthest.squared) farthest = {i, squared};
  }
  return farthest;
}

// Many points that come twice, too: of several it is the first.
TEST_F(FarthestPointTest, IsThatOfALoop) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    for (int round = 0; round < 300; ++round) {
      PointList points = directions(1 + random_.below(70), 1.0);
      for (std::size_t i = points.size(); i > 0; --i) points.push_back(points[i - 1]);
      const std::size_t first = random_.below(points.size());
      const std::size_t end = first + 1 + random_.below(points.size() - first);
      const Vec3 from(random_.direction());
      const FarthestPoint expected = one_by_one(points, first, end, from);
      const FarthestPoint found = farthest_point(points, first, end, from);
      ASSERT_EQ(found.index, expected.index) << "seed " << kSeed << ", " << hwy::TargetName(target);
      ASSERT_EQ(found.squared, expected.squared);
    }
  }
}

TEST_F(FarthestPointTest, ConesHoldTheirDirectionsClosely) {
  int bounded = 0;
  for (int round = 0; round < 3000; ++round) {
    const double spread = std::exp2(-random_.uniform(0, 20));
    const PointList points = directions(1 + random_.below(40), spread);
    DVec3 sum(0.0);
    for (std::size_t i = 0; i < points.size(); ++i) sum += DVec3(points[i]);
    const Cone cone = cone_around(points, 0, points.size(), sum);
    if (cone.is_whole()) continue;
    ++bounded;
    const double angle = 2.0 * std::atan(cone.half_tangent);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double away = 2.0 * std::asin(0.5 * glm::length(DVec3(points[i]) - cone.axis));
      ASSERT_LE(away, angle * (1 + 1e-6)) << "seed " << kSeed << ", round " << round;
    }
    ASSERT_LE(angle, 1.2 * std::asin(std::min(1.0, spread)) + 1e-6);
  }
  EXPECT_GT(bounded, 2500);
}

TEST_F(FarthestPointTest, ACommonConeHoldsBoth) {
  for (int round = 0; round < 3000; ++round) {
    const Cone one{random_.direction(), std::tan(random_.uniform(0, 0.4))};
    const Cone other{glm::normalize(one.axis + std::exp2(-random_.uniform(0, 30)) * random_.direction()),
                     std::tan(std::exp2(-random_.uniform(1, 30)))};
    const Cone both = cone_around(one, other);
    if (both.is_whole()) continue;
    for (const Cone& cone : {one, other}) {
      const double between = 2.0 * std::atan(half_tangent_across(glm::length(cone.axis - both.axis)));
      ASSERT_LE(between + 2.0 * std::atan(cone.half_tangent), 2.0 * std::atan(both.half_tangent) + 1e-8)
          << "seed " << kSeed << ", round " << round;
    }
  }
}

}  // namespace
}  // namespace palpate
