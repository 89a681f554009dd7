// Parallel faces and edges: one set, few points, the same force however the plateau is tessellated.
#include <gtest/gtest.h>

#include <algorithm>
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

// A plate over a pit that it covers: the floor's corners are at the foot of walls, where nothing is minimal,
// yet every point of the floor is.
TEST(Plateau, FloorOfAPitHasNoExtremePointsOfItsOwn) {
  TriangleSoup pit = shapes::box({1, 1, 1});
  // The upper face moves down into a rim: a frame of four walls around the floor.
  const double rim = 0.3, floor = 0.45;
  pit.triangles.erase(std::remove_if(pit.triangles.begin(), pit.triangles.end(),
                                     [&](const TriangleIndices& t) {
                                       return std::all_of(t.begin(), t.end(),
                                                          [&](auto v) { return pit.positions[v].z > 0.4; });
                                     }),
                      pit.triangles.end());
  const auto corner = [&](int k, double half, double z) {
    const double x = k == 0 || k == 3 ? -half : half, y = k < 2 ? -half : half;
    pit.positions.push_back({x, y, z});
    return static_cast<std::uint32_t>(pit.positions.size() - 1);
  };
  std::uint32_t outer[4], inner[4], bottom[4];
  for (int k = 0; k < 4; ++k) {
    outer[k] = corner(k, 0.5, 0.5);
    inner[k] = corner(k, rim, 0.5);
    bottom[k] = corner(k, rim, floor);
  }
  const auto quad = [&](auto a, auto b, auto c, auto d) {
    pit.triangles.insert(pit.triangles.end(), {{a, b, c}, {a, c, d}});
  };
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    quad(outer[k], outer[next], inner[next], inner[k]);
    quad(inner[k], inner[next], bottom[next], bottom[k]);
  }
  quad(bottom[0], bottom[1], bottom[2], bottom[3]);
  const auto body = make_model(pit);
  ASSERT_TRUE(body->mesh().report.final.watertight());
  const auto plate = make_model(shapes::box({2, 2, 0.1}));
  const LmdSet found = find_lmds(*body, *plate, shifted({0, 0, 0.5 + 0.05 + 0.01}), 0.1);
  EXPECT_EQ(found.set_count, 2u);
  double farthest = 0;
  for (const Lmd& lmd : found.lmds)
    if (std::abs(lmd.distance - 0.06) < 1e-6) farthest = std::max(farthest, lmd.point_a.x);
  EXPECT_NEAR(farthest, rim, 1e-3);
  EXPECT_LT(farthest, rim) << "the foot of the wall is no minimum";
}

TriangleSoup voxels(std::initializer_list<DVec3> cells) {
  TriangleSoup all;
  std::vector<DVec3> taken(cells);
  const auto filled = [&](const DVec3& cell) {
    return std::any_of(taken.begin(), taken.end(),
                       [&](const DVec3& other) { return glm::length(other - cell) < 0.5; });
  };
  for (const DVec3& cell : taken)
    for (int axis = 0; axis < 3; ++axis)
      for (int end = 0; end < 2; ++end) {
        DVec3 out(0.0), u(0.0), v(0.0);
        out[axis] = end ? 1 : -1;
        u[(axis + 1) % 3] = 1;
        v[(axis + 2) % 3] = 1;
        if (filled(cell + out)) continue;
        const DVec3 corner = cell + (end ? out : DVec3(0.0));
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), {corner, corner + u, corner + u + v, corner + v});
        const std::uint32_t second = end ? first + 1 : first + 3, fourth = end ? first + 3 : first + 1;
        all.triangles.insert(all.triangles.end(), {{first, second, first + 2}, {first, first + 2, fourth}});
      }
  return all;
}

// An edge of B ends exactly over the foot of a wall of A: the wall is nearer there, so nothing is minimal.
TEST(Plateau, FootOfAWallHoldsNoMinimum) {
  const auto bracket = make_model(voxels({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
  const auto box = make_model(voxels({{0, 0, 0}}));
  const LmdSet found = find_lmds(*bracket, *box, shifted({1, 1.3, -1.3}), 0.6);
  EXPECT_EQ(found.set_count, 1u);
  const DVec3 force = unit_spring_force(found, 0.6);
  EXPECT_NEAR(glm::length(force - DVec3(0, 0, -0.3)), 0.0, 1e-6);
  EXPECT_EQ(find_lmds(*bracket, *box, shifted({1.0000001, 1.3, -1.3}), 0.6).set_count, 1u);

  const LmdSet touching = find_lmds(*bracket, *box, shifted({1, 1.25, 0}), 0.6);
  for (const Lmd& lmd : touching.lmds)
    EXPECT_GT(lmd.point_a.y, 1.5) << "the reflex line is no place for a minimum";
}

TEST(Plateau, VertexOfTwoCubesThatShareAnEdgeHoldsNoMinimum) {
  const auto box = make_model(voxels({{0, 0, 0}}));
  const auto pair = make_model(voxels({{0, 1, 0}, {1, 1, 1}}));
  const LmdSet found = find_lmds(*box, *pair, shifted({-2, 0.25, -1}), 1.1);
  for (const Lmd& lmd : found.lmds) EXPECT_NEAR(lmd.distance, 0.25, 1e-6);
}

// The force of a plateau acts in its middle, however many corners are left out.
TEST(Plateau, RegularPolygonsBalance) {
  const auto plate = make_model(shapes::box({4, 4, 0.2}));
  for (int corners : {3, 5, 6, 7, 8, 9, 12, 24, 64, 200}) {
    const auto peg = make_model(shapes::cylinder(1.0, 0.5, corners, 2));
    const Pose pose = turned({0, 0, 1}, 0.1, {0.01, 0.02, 0.1 + 0.25 + 0.02});
    const LmdSet found = find_lmds(*plate, *peg, pose, 0.05);
    ASSERT_EQ(found.set_count, 1u) << corners;
    const DVec3 torque = unit_spring_torque(found, 0.05, pose.translation);
    EXPECT_NEAR(glm::length(torque), 0.0, 1e-4 * 0.03) << corners << " corners";
  }
}

// Caps cut like a cake, their hubs one over the other.
TEST(Plateau, ManyTrianglesAroundAHubCostNoMemory) {
  TriangleSoup cake;
  constexpr std::uint32_t kSlices = 300;
  for (double z : {-0.1, 0.1}) {
    for (std::uint32_t i = 0; i < kSlices; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSlices;
      cake.positions.push_back({std::cos(angle), std::sin(angle), z});
    }
    cake.positions.push_back({0, 0, z});
  }
  for (std::uint32_t i = 0; i < kSlices; ++i) {
    const std::uint32_t next = (i + 1) % kSlices, up = kSlices + 1;
    cake.triangles.insert(cake.triangles.end(), {{kSlices, next, i}, {up + kSlices, up + i, up + next}});
    cake.triangles.insert(cake.triangles.end(), {{i, next, up + next}, {i, up + next, up + i}});
  }
  const auto model = make_model(cake);
  ASSERT_TRUE(model->mesh().report.final.watertight());
  const LmdSet found = find_lmds(*model, *model, shifted({0, 0, 0.21}), 0.05);
  EXPECT_EQ(found.set_count, 1u);
  EXPECT_LE(found.lmds.size(), 8u);
  EXPECT_LE(found.work.triangle_pairs, 2u * kSlices * kSlices);
}

TEST(Plateau, TiltBeyondTheToleranceEndsIt) {
  const auto a = make_model(shapes::box({1, 1, 1}));
  const auto b = make_model(shapes::box({0.5, 0.5, 0.5}));
  EXPECT_EQ(find_lmds(*a, *b, turned({1, 2, 0}, 2e-7, {0.1, 0, 0.8}), 0.2).lmds.size(), 4u);
  EXPECT_EQ(find_lmds(*a, *b, turned({1, 2, 0}, 1e-5, {0.1, 0, 0.8}), 0.2).lmds.size(), 1u);
}

}  // namespace
}  // namespace palpate
