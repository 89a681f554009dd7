// Shapes whose local minimum distances are known on paper.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assets/shapes/box.h"
#include "assets/shapes/l_bracket.h"
#include "assets/shapes/platonic.h"
#include "assets/shapes/round_solids.h"
#include "tests/search/find.h"
#include "tests/support/models.h"

namespace palpate {
namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2;

TEST(Analytic, CornerOverFaceIsOneMinimum) {
  const auto a = make_model(shapes::box({1, 1, 1}));
  const auto b = make_model(shapes::box({0.2, 0.2, 0.2}));
  // A body diagonal of B stands on A's upper face.
  const double reach = 0.1 * std::sqrt(3.0);
  const Pose pose = turned({1, -1, 0}, std::acos(1 / std::sqrt(3.0)), {0.1, 0.03, 0.5 + reach + 0.01});
  const LmdSet found = find_lmds(*a, *b, pose, 0.05);
  ASSERT_EQ(found.lmds.size(), 1u);
  EXPECT_NEAR(found.lmds[0].distance, 0.01, 1e-7);
  EXPECT_EQ(found.lmds[0].feature_a.kind, FeatureKind::kFace);
  EXPECT_EQ(found.lmds[0].feature_b.kind, FeatureKind::kVertex);
  EXPECT_NEAR(found.lmds[0].normal.z, 1.0, 1e-12);
  EXPECT_EQ(found.lmds[0].weight, 1.0);
  EXPECT_FALSE(found.overlapping());
}

TEST(Analytic, CrossedEdgesAreOneMinimum) {
  const auto box = make_model(shapes::box({1, 1, 1}));
  // A's edge along y at its upper side meets B's edge along x at its lower side.
  const Pose tilt_a = turned({0, 1, 0}, kQuarterTurn / 2), tilt_b = turned({1, 0, 0}, kQuarterTurn / 2);
  const Pose world_b{tilt_b.rotation, {0.2, 0.1, std::sqrt(2.0) + 0.05}};
  const LmdSet found = find_lmds(*box, *box, inverse(tilt_a) * world_b, 0.2);
  ASSERT_EQ(found.lmds.size(), 1u);
  EXPECT_NEAR(found.lmds[0].distance, 0.05, 1e-12);
  EXPECT_EQ(found.lmds[0].feature_a.kind, FeatureKind::kEdge);
  EXPECT_EQ(found.lmds[0].feature_b.kind, FeatureKind::kEdge);
}

TEST(Analytic, SpheresMeetOnceOnTheLineOfCentres) {
  const auto a = make_model(shapes::icosphere(0.1, 20));
  const auto b = make_model(shapes::icosphere(0.05, 20));
  const DVec3 direction = glm::normalize(DVec3(1, 2, 3));
  const Pose pose = turned({3, 1, 2}, 0.7, direction * 0.16);
  const LmdSet found = find_lmds(*a, *b, pose, 0.03);
  ASSERT_GE(found.set_count, 1u);
  for (const Lmd& lmd : found.lmds) EXPECT_GT(glm::dot(lmd.normal, direction), 0.98);
  double least = 1.0;
  for (const Lmd& lmd : found.lmds) least = std::min(least, lmd.distance);
  EXPECT_NEAR(least, 0.01, 4e-4);  // the sagitta of both tessellations
}

TEST(Analytic, BallInSocketHasAMinimumInEveryDirection) {
  // A small tetrahedron in a hollow ball: each of its corners is nearest to the wall, and so are saddles
  // between.
  const auto shell = make_model(shapes::nested_cavities());
  const auto probe = make_model(shapes::tetrahedron(0.001));
  const LmdSet found = find_lmds(*shell, *probe, shifted({0, 0, 0}), 1.0);
  EXPECT_GE(found.set_count, 1u);
}

TEST(Analytic, ReflexEdgeHoldsNoMinimum) {
  const auto bracket = make_model(shapes::l_bracket());
  const auto probe = make_model(shapes::icosphere(0.004, 3));
  const auto& mesh = bracket->mesh();
  for (std::uint32_t edge = 0; edge < mesh.edges.size(); ++edge) {
    if (mesh.edge_flags[edge].active) continue;
    const DVec3 middle = 0.5 * (mesh.frame.metres(mesh.position(mesh.edges[edge].vertex[0])) +
                                mesh.frame.metres(mesh.position(mesh.edges[edge].vertex[1])));
    for (const DVec3& side : {DVec3(1, 0, 1), DVec3(1, 1, 0), DVec3(0, 1, 1), DVec3(-1, 0, 1)}) {
      const LmdSet found = find_lmds(*bracket, *probe, shifted(middle + 0.01 * side), 0.02);
      for (const Lmd& lmd : found.lmds) EXPECT_FALSE(lmd.feature_a == (Feature{FeatureKind::kEdge, edge}));
    }
  }
}

TEST(Analytic, NothingBeyondTheCutoff) {
  const auto box = make_model(shapes::box({1, 1, 1}));
  EXPECT_EQ(find_lmds(*box, *box, shifted({1.2, 0, 0}), 0.1999).set_count, 0u);
  EXPECT_EQ(find_lmds(*box, *box, shifted({1.2, 0, 0}), 0.2001).set_count, 1u);
}

TEST(Analytic, BoxInsideABoxTouchesNothing) {
  // From inside, A's faces look away: there is no minimum and no overlap.
  const auto a = make_model(shapes::box({1, 1, 1}));
  const auto b = make_model(shapes::box({0.9, 0.9, 0.9}));
  const LmdSet found = find_lmds(*a, *b, shifted({0.01, 0.02, 0.015}), 0.2);
  EXPECT_EQ(found.set_count, 0u);
  EXPECT_FALSE(found.overlapping());
}

TEST(Analytic, DoubleSidedBoxIsTouchedFromInside) {
  MeshOptions options;
  options.all_double_sided = true;
  const auto a = make_model(shapes::box({1, 1, 1}), options);
  const auto b = make_model(shapes::box({0.9, 0.9, 0.9}));
  const LmdSet found = find_lmds(*a, *b, shifted({0, 0, 0}), 0.06);
  EXPECT_EQ(found.set_count, 6u);
  for (const Lmd& lmd : found.lmds) EXPECT_NEAR(lmd.distance, 0.05, 1e-7);
}

TEST(Analytic, CrossingBoxesOverlap) {
  const auto box = make_model(shapes::box({1, 1, 1}));
  const LmdSet found = find_lmds(*box, *box, shifted({0.9, 0.3, 0.2}), 0.05);
  EXPECT_TRUE(found.overlapping());
  EXPECT_FALSE(found.overlaps.empty());
}

TEST(Analytic, FlushBoxesTouch) {
  const auto box = make_model(shapes::box({1, 1, 1}));
  EXPECT_TRUE(find_lmds(*box, *box, shifted({1, 0, 0}), 0.05).overlapping());
  EXPECT_TRUE(find_lmds(*box, *box, shifted({1, 1, 0}), 0.05).overlapping());
  EXPECT_TRUE(find_lmds(*box, *box, shifted({1, 1, 1}), 0.05).overlapping());
}

TEST(Analytic, OverlapListIsCutAtItsLimit) {
  const auto box = make_model(shapes::box({1, 1, 1}, {8, 8, 8}));
  SearchOptions options;
  options.cutoff = 0.01;
  options.max_overlaps = 3;
  LmdSearch search;
  LmdSet found;
  search.run(*box, *box, shifted({0.5, 0.013, 0.017}), options, found);
  EXPECT_EQ(found.overlaps.size(), 3u);
  EXPECT_TRUE(found.overlaps_cut);
}

}  // namespace
}  // namespace palpate
