#include "engine/mesh/winding.h"

#include <gtest/gtest.h>

#include "tests/mesh/soups.h"

namespace palpate {
namespace {

// Two triangles on the edge from (0, 0) to (0, 1) that are wound against each other; `area` times two is the
// second's.
TriangleSoup disagreeing_pair(double area) {
  TriangleSoup soup;
  soup.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {2 * area, 0, 0}};
  soup.triangles = {{0, 1, 2}, {0, 1, 3}};
  return soup;
}

double facing_of(const CleanTriangles& surface, std::size_t triangle) {
  const auto [a, b, c] = corners(surface, triangle);
  return glm::cross(b - a, c - a).z;
}

TEST(Winding, LeavesAGoodSurfaceAlone) {
  const TriangleSoup soup = torus(2.0, 0.5);
  const Cleaned result = cleaned(soup);
  EXPECT_EQ(result.report.reversed_triangles, 0u);
  EXPECT_EQ(result.surface.triangles.size(), soup.triangles.size());
  EXPECT_TRUE(result.report.notes.empty());
}

TEST(Winding, TurnsAClosedSurfaceOutward) {
  const Cleaned result = cleaned(reversed(torus(2.0, 0.5)));
  EXPECT_EQ(result.report.source.orientation, Orientation::kInward);
  EXPECT_EQ(result.report.final.orientation, Orientation::kOutward);
  EXPECT_EQ(result.report.flipped_components, 1u);
  EXPECT_EQ(result.report.reversed_triangles, result.surface.triangles.size());
  EXPECT_EQ(result.report.notes.back(), "Turned 1 closed component that faced the wrong way.");
}

TEST(Winding, RepairsRandomWindings) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const TriangleSoup good = torus(2.0, 0.5);
    const TriangleSoup soup = with_random_windings(good, random);
    const Cleaned result = cleaned(soup);
    EXPECT_EQ(result.report.final.orientation, Orientation::kOutward);
    std::uint64_t wrong = 0;
    for (std::size_t t = 0; t < good.triangles.size(); ++t) wrong += soup.triangles[t] != good.triangles[t];
    EXPECT_EQ(result.report.reversed_triangles, wrong);
  }
}

TEST(Winding, TheLargerAreaKeepsItsWinding) {
  const Cleaned first = cleaned(disagreeing_pair(0.4));
  EXPECT_GT(facing_of(first.surface, 0), 0);
  EXPECT_GT(facing_of(first.surface, 1), 0);
  const Cleaned second = cleaned(disagreeing_pair(0.6));
  EXPECT_LT(facing_of(second.surface, 0), 0);
  EXPECT_LT(facing_of(second.surface, 1), 0);
  EXPECT_EQ(second.report.reversed_triangles, 1u);
  EXPECT_EQ(second.report.flipped_components, 0u);
}

TEST(Winding, InATieTheFirstTriangleKeepsItsWinding) {
  EXPECT_GT(facing_of(cleaned(disagreeing_pair(0.5)).surface, 0), 0);
}

TEST(Winding, AnOpenSurfaceKeepsItsFacing) {
  TriangleSoup soup = reversed(cube(DVec3(0.0), 1.0));
  soup.triangles.pop_back();
  EXPECT_EQ(cleaned(soup).report.reversed_triangles, 0u);
}

TEST(Winding, KeepsAMoebiusStripAsItCame) {
  const TriangleSoup strip = moebius_strip();
  const Cleaned result = cleaned(joined({strip, reversed(cube(DVec3(9.0), 1.0))}));
  EXPECT_EQ(result.report.final.inconsistent_edges, 1u);
  EXPECT_EQ(result.report.final.orientation, Orientation::kMixed);
  EXPECT_EQ(result.report.reversed_triangles, 12u) << "those of the cube alone";
  EXPECT_EQ(
      result.report.notes.front(),
      "Kept the winding of 1 part of the surface that, like a Möbius strip, cannot be wound consistently.");
}

TEST(Winding, AMoebiusStripOfMixedWindingIsNotTouched) {
  std::mt19937 random(3);
  const Cleaned result = cleaned(with_random_windings(moebius_strip(), random));
  EXPECT_EQ(result.report.reversed_triangles, 0u);
  EXPECT_EQ(result.report.final.inconsistent_edges, result.report.source.inconsistent_edges);
}

TEST(Winding, CanBeKept) {
  MeshOptions options;
  options.keep_winding = true;
  const Cleaned result = cleaned(reversed(cube(DVec3(0.0), 1.0)), options);
  EXPECT_EQ(result.report.final.orientation, Orientation::kInward);
  EXPECT_EQ(result.report.reversed_triangles, 0u);
}

// The edge that the cubes share has four triangles, so each is a patch of its own, and closed.
TEST(Winding, TurnsSolidsThatShareAnEdgeOneByOne) {
  const TriangleSoup first = cube(DVec3(0.0), 1.0), second = cube(DVec3(2, 2, 0), 1.0);
  const Cleaned result = cleaned(joined({reversed(first), second}));
  EXPECT_EQ(result.report.flipped_components, 1u);
  EXPECT_NEAR(enclosed_volume(result.surface, 0, 12), 8, 1e-12);
  EXPECT_NEAR(enclosed_volume(result.surface, 12, 24), 8, 1e-12);
}

}  // namespace
}  // namespace palpate
