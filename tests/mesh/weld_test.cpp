#include "engine/mesh/weld.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/mesh/soups.h"

namespace palpate {
namespace {

// Every corner a vertex of its own.
TriangleSoup unindexed(const TriangleSoup& soup) {
  TriangleSoup loose;
  for (const TriangleIndices& triangle : soup.triangles) {
    const auto base = static_cast<std::uint32_t>(loose.positions.size());
    for (std::uint32_t vertex : triangle) loose.positions.push_back(soup.positions[vertex]);
    loose.triangles.push_back({base, base + 1, base + 2});
  }
  return loose;
}

// A row of separate upright triangles at the given places along x.
TriangleSoup row_of_triangles(const std::vector<double>& places) {
  TriangleSoup soup;
  for (double x : places) {
    const auto base = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), {{x, 0, 0}, {x, 100, 0}, {x, 0, 100}});
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  return soup;
}

TEST(Weld, MakesEqualPositionsOneVertex) {
  const Cleaned result = cleaned(unindexed(cube(DVec3(0.0), 1.0)));
  EXPECT_EQ(result.report.stored_vertices, 36u);
  EXPECT_EQ(result.report.source.vertices, 8u);
  EXPECT_TRUE(result.report.final.watertight());
}

TEST(Weld, TakesNegativeZeroForZero) {
  TriangleSoup soup;
  soup.positions = {{0.0, 0, 0}, {-0.0, -0.0, -0.0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  soup.triangles = {{0, 2, 3}, {2, 1, 4}};
  EXPECT_EQ(cleaned(soup).report.source.vertices, 4u);
}

TEST(Weld, KeepsNeighbouringFloatsApart) {
  const float x = 0.7f;
  const Cleaned result = cleaned(row_of_triangles({x, std::nextafter(x, 1.0f)}));
  EXPECT_EQ(result.report.source.vertices, 6u);
  EXPECT_EQ(result.surface.triangles.size(), 2u);
}

TEST(Weld, NumbersVerticesInOrderOfFirstUse) {
  TriangleSoup soup = cube(DVec3(0.0), 1.0);
  std::swap(soup.triangles.front(), soup.triangles.back());
  const Cleaned result = cleaned(soup);
  std::uint32_t next = 0;
  for (const TriangleIndices& triangle : result.surface.triangles) {
    for (std::uint32_t vertex : triangle) {
      EXPECT_LE(vertex, next);
      next = std::max(next, vertex + 1);
    }
  }
  EXPECT_EQ(next, 8u);
}

// float32 coordinates far from the origin, near it and across it must come back bit for bit.
TEST(Weld, KeepsEveryBitOfFloat32Coordinates) {
  std::mt19937 random(20040427);
  for (const DVec3& offset : {DVec3(1e6), DVec3(-1e6, 0, 1e6), DVec3(3e6, -40, 0.001), DVec3(0.0)}) {
    std::uniform_real_distribution<float> spread(-100.0f, 100.0f);
    TriangleSoup soup;
    for (std::uint32_t i = 0; i < 300; ++i)
      soup.positions.emplace_back(static_cast<float>(offset.x) + spread(random),
                                  static_cast<float>(offset.y) + spread(random),
                                  static_cast<float>(offset.z) + spread(random));
    for (std::uint32_t i = 0; i < 300; i += 3) soup.triangles.push_back({i, i + 1, i + 2});
    for (DVec3& position : soup.positions) position = DVec3(Vec3(position));
    const Cleaned result = cleaned(soup);
    ASSERT_EQ(result.surface.triangles.size(), 100u);
    for (std::size_t t = 0; t < 100; ++t) {
      const std::array<DVec3, 3> back = corners(result.surface, t);
      for (int k = 0; k < 3; ++k) EXPECT_EQ(back[k], soup.positions[soup.triangles[t][k]]);
    }
  }
}

TEST(Weld, ToleranceClosesCracks) {
  TriangleSoup soup = unindexed(ball(DVec3(0.3), 1.0));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
  for (DVec3& position : soup.positions) position += DVec3(noise(random), noise(random), noise(random));
  EXPECT_EQ(cleaned(soup).report.final.boundary_edges, soup.positions.size());
  MeshOptions options;
  options.weld_tolerance = 1e-3;
  const Cleaned result = cleaned(soup, options);
  EXPECT_TRUE(result.report.final.watertight());
  EXPECT_EQ(result.report.final.vertices, 42u);
  EXPECT_EQ(result.report.source.vertices, soup.positions.size()) << "the source is welded exactly";
  EXPECT_EQ(result.report.notes.front(), "Welded 198 vertices to others within the tolerance.");
}

TEST(Weld, ToleranceIsInMetresAndReachesExactlySoFar) {
  MeshOptions options;
  options.weld_tolerance = 0.25;
  EXPECT_EQ(cleaned(row_of_triangles({0.0, 0.25}), options).report.final.vertices, 3u);
  EXPECT_EQ(cleaned(row_of_triangles({0.0, 0.2500001}), options).report.final.vertices, 6u);
}

// The second welds to the first; the third is near the second only, so it stays; the fourth welds to the
// third.
TEST(Weld, ToleranceDoesNotChain) {
  MeshOptions options;
  options.weld_tolerance = 1.0;
  const Cleaned result = cleaned(row_of_triangles({0.0, 0.75, 1.5, 2.25}), options);
  EXPECT_EQ(result.report.final.vertices, 6u);
  EXPECT_EQ(corners(result.surface, 0)[0].x, 0.0);
  EXPECT_EQ(corners(result.surface, 1)[0].x, 1.5);
}

TEST(Weld, ToleranceWeldsToTheEarliestNotTheNearest) {
  MeshOptions options;
  options.weld_tolerance = 1.0;
  TriangleSoup soup = row_of_triangles({0.0, 1.5, 0.9});
  soup.positions[7].y = 50;
  const Cleaned result = cleaned(soup, options);
  ASSERT_EQ(result.surface.triangles.size(), 3u);
  EXPECT_EQ(corners(result.surface, 2)[0].x, 0.0);
}

TEST(Weld, ToleranceAgreesWithTheDirectMethod) {
  std::mt19937 random(99);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  for (double tolerance : {1e-9, 0.01, 0.1, 0.5}) {
    CleanTriangles surface;
    for (int i = 0; i < 500; ++i)
      surface.positions.emplace_back(uniform(random), uniform(random), uniform(random));
    for (std::uint32_t i = 0; i + 2 < 500; ++i) surface.triangles.push_back({i, i + 1, i + 2});
    const CleanTriangles before = surface;
    std::vector<Vec3> kept;
    const auto earliest = [&](const Vec3& p) {
      const auto near = [&](const Vec3& q) { return glm::distance(DVec3(p), DVec3(q)) <= tolerance; };
      return std::find_if(kept.begin(), kept.end(), near);
    };
    for (const Vec3& position : before.positions)
      if (earliest(position) == kept.end()) kept.push_back(position);
    EXPECT_EQ(weld_near(surface, tolerance), 500 - kept.size());
    EXPECT_EQ(surface.positions, kept);
    for (std::size_t t = 0; t < before.triangles.size(); ++t)
      EXPECT_EQ(surface.positions[surface.triangles[t][0]],
                *earliest(before.positions[before.triangles[t][0]]));
  }
}

TEST(Weld, AToleranceBeyondTheModelLeavesNothing) {
  MeshOptions options;
  options.weld_tolerance = 1e300;
  MeshReport report;
  const Result<CleanTriangles> result = clean_triangles(cube(DVec3(0.0), 1.0), options, report);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kNoTriangles);
  EXPECT_EQ(report.degenerate_triangles, 12u);
}

}  // namespace
}  // namespace palpate
