#include "engine/mesh/surface_counts.h"

#include <gtest/gtest.h>

#include "tests/mesh/soups.h"

namespace palpate {
namespace {

SurfaceCounts counts_of(const TriangleSoup& soup) {
  return cleaned(soup).report.source;
}

TEST(SurfaceCounts, OfACube) {
  const SurfaceCounts counts = counts_of(cube(DVec3(5.0), 1.0));
  EXPECT_EQ(counts.triangles, 12u);
  EXPECT_EQ(counts.vertices, 8u);
  EXPECT_EQ(counts.edges, 18u);
  EXPECT_EQ(counts.components, 1u);
  EXPECT_TRUE(counts.watertight());
  EXPECT_EQ(counts.orientation, Orientation::kOutward);
  EXPECT_EQ(counts_of(reversed(cube(DVec3(5.0), 1.0))).orientation, Orientation::kInward);
}

TEST(SurfaceCounts, OfAnOpenCube) {
  TriangleSoup soup = cube(DVec3(0.0), 1.0);
  soup.triangles.pop_back();
  const SurfaceCounts counts = counts_of(soup);
  EXPECT_EQ(counts.boundary_edges, 3u);
  EXPECT_FALSE(counts.watertight());
  EXPECT_EQ(counts.orientation, Orientation::kOpen);
}

TEST(SurfaceCounts, OfOneReversedTriangle) {
  TriangleSoup soup = cube(DVec3(0.0), 1.0);
  std::swap(soup.triangles[3][0], soup.triangles[3][1]);
  const SurfaceCounts counts = counts_of(soup);
  EXPECT_EQ(counts.inconsistent_edges, 3u);
  EXPECT_EQ(counts.boundary_edges, 0u);
  EXPECT_FALSE(counts.watertight());
  EXPECT_EQ(counts.orientation, Orientation::kMixed);
}

TEST(SurfaceCounts, ComponentsAreJoinedThroughVertices) {
  EXPECT_EQ(counts_of(joined({cube(DVec3(0.0), 1.0), cube(DVec3(2.0), 1.0)})).components, 1u);
  EXPECT_EQ(counts_of(joined({cube(DVec3(0.0), 1.0), cube(DVec3(3.0), 1.0)})).components, 2u);
}

TEST(SurfaceCounts, TwoCubesOnOneEdgeAreNotManifold) {
  const SurfaceCounts counts = counts_of(joined({cube(DVec3(0.0), 1.0), cube(DVec3(2, 2, 0), 1.0)}));
  EXPECT_EQ(counts.nonmanifold_edges, 1u);
  EXPECT_FALSE(counts.watertight());
}

TEST(SurfaceCounts, EdgesAreOfTrianglesWithThreeDifferentCorners) {
  TriangleSoup soup = cube(DVec3(0.0), 1.0);
  soup.triangles.push_back({0, 7, 0});
  const SurfaceCounts counts = counts_of(soup);
  EXPECT_EQ(counts.triangles, 13u);
  EXPECT_EQ(counts.edges, 18u);
  EXPECT_TRUE(counts.watertight());
}

TEST(SurfaceCounts, AClosedSurfaceThatEnclosesNothingIsOpen) {
  TriangleSoup sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {2, 1, 0}};
  EXPECT_EQ(counts_of(sheet).orientation, Orientation::kOpen);
}

}  // namespace
}  // namespace palpate
