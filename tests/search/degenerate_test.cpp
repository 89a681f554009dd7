// Poses and shapes at the edge of what numbers can say: nothing but finite answers comes back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/shapes/box.h"
#include "assets/shapes/platonic.h"
#include "tests/search/find.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

void expect_sound(const LmdSet& found, double cutoff) {
  double weights = 0;
  for (const Lmd& lmd : found.lmds) {
    EXPECT_TRUE(std::isfinite(glm::dot(lmd.point_a, lmd.point_b)));
    EXPECT_NEAR(glm::length(lmd.normal), 1.0, 1e-9);
    EXPECT_GT(lmd.distance, 0.0);
    EXPECT_LE(lmd.distance, cutoff * (1 + 1e-9));
    weights += lmd.weight;
  }
  EXPECT_NEAR(weights, found.set_count, 1e-9);
}

TEST(Degenerate, GapsDownToAFewUlpsAreFoundOrTouch) {
  const auto a = make_model(shapes::box({1, 1, 1}));
  const auto b = make_model(shapes::tetrahedron(0.1));
  Random random(11);
  for (double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-14, 1e-15, 1e-16}) {
    for (int i = 0; i < 50; ++i) {
      Pose pose{random.rotation(), DVec3(0.0)};
      double lowest = 1.0;
      for (std::uint32_t v = 0; v < 4; ++v)
        lowest = std::min(lowest, (pose.rotation * b->mesh().frame.metres(b->mesh().position(v))).z);
      pose.translation = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0.5 - lowest + gap};
      const LmdSet found = find_lmds(*a, *b, pose, 0.01);
      expect_sound(found, 0.01);
      EXPECT_TRUE(found.set_count == 1 || found.overlapping()) << "gap " << gap;
      if (gap >= 1e-12 && found.set_count == 1) {
        EXPECT_NEAR(found.lmds[0].distance, gap, 1e-15 + 1e-6 * gap);
      }
    }
  }
}

// A ridge along x, and one that is upside down over it.
TriangleSoup ridge() {
  return {{{-1, 0, 0}, {-1, 1, -1}, {-1, -1, -1}, {1, 0, 0}, {1, 1, -1}, {1, -1, -1}},
          {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {0, 2, 5}, {0, 5, 3}, {1, 4, 5}, {1, 5, 2}},
          {}};
}

TEST(Degenerate, EdgesThatAreNearlyParallelAreNearestWhereTheyCross) {
  const auto model = make_model(ridge());
  const DMat3 over = turned({1, 0, 0}, std::numbers::pi).rotation;
  Random random(12);
  for (double angle : {1e-6, 1e-8, 2e-9, 5e-10, 1e-10, 1e-11, 1e-12}) {
    for (int i = 0; i < 20; ++i) {
      // So near that the ends, which are beside each other, are much farther apart.
      const double gap = angle * random.uniform(0.1, 1.0), at = random.uniform(-0.5, 0.5);
      const DMat3 yaw = turned({0, 0, 1}, angle).rotation;
      const LmdSet found = find_lmds(*model, *model, {yaw * over, {at, 0, gap}}, 0.01);
      // Ends may be minima, too, by the tolerance of what is parallel; the nearest of all is the crossing.
      ASSERT_GE(found.set_count, 1u) << "angle " << angle << " gap " << gap;
      const Lmd nearest =
          *std::min_element(found.lmds.begin(), found.lmds.end(),
                            [](const Lmd& one, const Lmd& other) { return one.distance < other.distance; });
      EXPECT_NEAR(nearest.distance, gap, 1e-15 + 1e-6 * gap) << "angle " << angle;
      EXPECT_NEAR(nearest.point_a.x, at, 0.05) << "angle " << angle;
    }
  }
}

TEST(Degenerate, CutoffLargerThanTheScene) {
  const auto a = make_model(shapes::icosphere(0.1, 4));
  const auto b = make_model(shapes::box({0.1, 0.1, 0.1}));
  const LmdSet found = find_lmds(*a, *b, shifted({0.5, 0.1, 0.2}), 1e6);
  EXPECT_GE(found.set_count, 1u);
  expect_sound(found, 1e6);
}

TEST(Degenerate, FarAwayIsNothing) {
  const auto box = make_model(shapes::box({1, 1, 1}));
  for (double far : {1e3, 1e9, 1e18, 1e30, 1e150}) {
    const LmdSet found = find_lmds(*box, *box, shifted({far, 0, 0}), 1.0);
    EXPECT_EQ(found.set_count, 0u);
    EXPECT_FALSE(found.overlapping());
  }
}

TEST(Degenerate, ModelsOfVeryDifferentSize) {
  const auto large = make_model(shapes::box({1e4, 1e4, 1e4}));
  const auto small = make_model(shapes::box({1e-3, 1e-3, 1e-3}));
  const Pose pose = shifted({12.5, -7.25, 5e3 + 0.5e-3 + 1e-4});
  const LmdSet forward = find_lmds(*large, *small, pose, 1e-3);
  const LmdSet backward = find_lmds(*small, *large, inverse(pose), 1e-3);
  for (const LmdSet* found : {&forward, &backward}) {
    ASSERT_EQ(found->set_count, 1u);
    expect_sound(*found, 1e-3);
    EXPECT_NEAR(found->lmds[0].distance, 1e-4, 1e-8);
  }
}

TEST(Degenerate, LoneTriangles) {
  TriangleSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}};
  const auto triangle = make_model(soup);
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const LmdSet found = find_lmds(*triangle, *triangle, {random.rotation(), random.direction() * 0.8}, 2.0);
    expect_sound(found, 2.0);
    EXPECT_LE(found.set_count, 1u);  // the product of two triangles is convex
  }
}

// A sheet whose lower border is a sliver as thin as can be without being nothing: anywhere else than in its
// own frame two of its corners are rounded to one point.
TriangleSoup sheet_with_sliver(double thickness) {
  TriangleSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {thickness, -thickness, 0}, {0, 1, 0}, {1, 1, 0}};
  soup.triangles = {{0, 2, 1}, {0, 1, 4}, {0, 4, 3}};
  soup.double_sided.assign(3, true);
  return soup;
}

TEST(Degenerate, SliversThatRoundingTakesTheAreaOf) {
  TriangleSoup open;  // at its border nothing tells outside from inside
  open.positions = {{0, 0, 0}, {0.2, 0, 0}, {0, 0.2, 0}};
  open.triangles = {{0, 1, 2}};
  const auto probe = make_model(open);
  Random random(17);
  for (const double thickness : {1e-3, 1e-9, 1e-15, 1e-17, 1e-25, 1e-37}) {
    const auto sheet = make_model(sheet_with_sliver(thickness));
    ASSERT_EQ(sheet->mesh().triangles.size(), 3u) << thickness;
    for (int i = 0; i < 300; ++i) {
      const Pose pose{random.rotation(), DVec3(0.1, 0.1, 0.0) + random.direction() * 0.3};
      const LmdSet as_a = find_lmds(*sheet, *probe, pose, 0.5);
      const LmdSet as_b = find_lmds(*probe, *sheet, inverse(pose), 0.5);
      expect_sound(as_a, 0.5);
      expect_sound(as_b, 0.5);
      EXPECT_EQ(as_a.set_count, as_b.set_count) << thickness << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace palpate
