// Parallel faces and edges: one set, few points, the same force however the plateau is tessellated.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assets/shapes/box.h"
#include "assets/shapes/round_solids.h"
#include "tests/search/find.h"
#include "tests/support/models.h"

namespace palpate {
namespace {

double weight_sum(const LmdSet& found) {
  double sum = 0;
  for (const Lmd& lmd : found.lmds) sum += lmd.weight;
  return sum;
}

TEST(Plateau, BoxOnBoxIsFourEqualPoints) {
  const auto a = make_model(shapes::box({1, 1, 1}));
  const auto b = make_model(shapes::box({0.5, 0.5, 0.5}));
  const LmdSet found = find_lmds(*a, *b, shifted({0.03, 0.07, 0.85}), 0.2);
  ASSERT_EQ(found.lmds.size(), 4u);
  EXPECT_EQ(found.set_count, 1u);
  for (const Lmd& lmd : found.lmds) {
    EXPECT_NEAR(lmd.distance, 0.1, 1e-7);
    EXPECT_NEAR(lmd.weight, 0.25, 1e-7);
    EXPECT_EQ(lmd.set, 0u);
  }
}

TEST(Plateau, TurnedBoxesMeetInAnOctagon) {
  const auto box = make_model(shapes::box({1, 1, 1}));
  const LmdSet found = find_lmds(*box, *box, turned({0, 0, 1}, std::numbers::pi / 4, {0, 0, 1.01}), 0.05);
  EXPECT_EQ(found.set_count, 1u);
  ASSERT_EQ(found.lmds.size(), 8u);
  EXPECT_NEAR(weight_sum(found), 1.0, 1e-12);
  for (const Lmd& lmd : found.lmds) {
    EXPECT_EQ(lmd.feature_a.kind, FeatureKind::kEdge);
    EXPECT_EQ(lmd.feature_b.kind, FeatureKind::kEdge);
    EXPECT_NEAR(lmd.weight, 0.125, 1e-6);
  }
}

TEST(Plateau, ForceDoesNotDependOnTessellation) {
  const double cutoff = 0.05;
  const Pose pose = turned({0, 0, 1}, 0.3, {0.21, 0.13, 0.76});
  DVec3 first_force(0.0), first_torque(0.0);
  for (int divisions : {1, 3, 16}) {
    const auto a = make_model(shapes::box({1, 1, 1}, {divisions, divisions, divisions}));
    const auto b = make_model(shapes::box({0.5, 0.5, 0.5}, {divisions, divisions, divisions}));
    const LmdSet found = find_lmds(*a, *b, pose, cutoff);
    EXPECT_EQ(found.set_count, 1u);
    EXPECT_LE(found.lmds.size(), 8u);
    const DVec3 force = unit_spring_force(found, cutoff);
    const DVec3 torque = unit_spring_torque(found, cutoff, pose.translation);
    if (divisions == 1) first_force = force, first_torque = torque;
    EXPECT_NEAR(glm::length(force - first_force), 0.0, 1e-9);
    EXPECT_NEAR(glm::length(torque - first_torque), 0.0, 1e-9);
  }
}

TEST(Plateau, ParallelEdgesAreTheEndsOfASegment) {
  // Two boxes edge to edge, both tilted by 45° about y: the edges along y overlap over 0.7.
  const auto box = make_model(shapes::box({1, 1, 1}));
  const Pose tilt = turned({0, 1, 0}, std::numbers::pi / 4);
  const Pose upper{tilt.rotation, {0, 0.3, std::sqrt(2.0) + 0.1}};
  const LmdSet found = find_lmds(*box, *box, inverse(tilt) * upper, 0.2);
  EXPECT_EQ(found.set_count, 1u);
  ASSERT_EQ(found.lmds.size(), 2u);
  EXPECT_NEAR(found.lmds[0].weight, 0.5, 1e-9);
  EXPECT_NEAR(glm::length(found.lmds[0].point_a - found.lmds[1].point_a), 0.7, 1e-7);
}

TEST(Plateau, RoundEndIsThinnedToEightPoints) {
  const auto plate = make_model(shapes::plate());
  const auto peg = make_model(shapes::cylinder(0.03, 0.1, 64, 3));
  const double top = plate->bounds().high.z;
  const LmdSet found = find_lmds(*plate, *peg, shifted({0.001, 0.002, top + 0.05 + 0.004}), 0.01);
  EXPECT_EQ(found.set_count, 1u);
  EXPECT_EQ(found.lmds.size(), 8u);
  EXPECT_NEAR(weight_sum(found), 1.0, 1e-12);
  // The weighted middle of the points is that of the disc.
  const DVec3 torque = unit_spring_torque(found, 0.01, {0.001, 0.002, 0});
  EXPECT_NEAR(glm::length(torque) / glm::length(unit_spring_force(found, 0.01)), 0.0, 0.03 * 0.02);
}

TEST(Plateau, SeparatePlateausAreSeparateSets) {
  // Two legs of one table: a body with two feet over a plate.
  TriangleSoup feet = shapes::box({0.02, 0.02, 0.05});
  const std::size_t corners = feet.positions.size();
  const TriangleSoup foot = feet;
  for (DVec3 position : foot.positions) feet.positions.push_back(position + DVec3(0.06, 0, 0));
  for (TriangleIndices t : foot.triangles) {
    for (auto& vertex : t) vertex += static_cast<std::uint32_t>(corners);
    feet.triangles.push_back(t);
  }
  const auto table = make_model(feet);
  const auto plate = make_model(shapes::plate());
  const LmdSet found =
      find_lmds(*plate, *table, shifted({-0.03, 0, plate->bounds().high.z + 0.025 + 0.003}), 0.005);
  EXPECT_EQ(found.set_count, 2u);
  EXPECT_EQ(found.lmds.size(), 8u);
  EXPECT_NEAR(weight_sum(found), 2.0, 1e-12);
}

TEST(Plateau, TiltBeyondTheToleranceEndsIt) {
  const auto a = make_model(shapes::box({1, 1, 1}));
  const auto b = make_model(shapes::box({0.5, 0.5, 0.5}));
  EXPECT_EQ(find_lmds(*a, *b, turned({1, 2, 0}, 2e-7, {0.1, 0, 0.8}), 0.2).lmds.size(), 4u);
  EXPECT_EQ(find_lmds(*a, *b, turned({1, 2, 0}, 1e-5, {0.1, 0, 0.8}), 0.2).lmds.size(), 1u);
}

}  // namespace
}  // namespace palpate
