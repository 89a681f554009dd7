// What single shapes are for, beyond being closed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "assets/shapes/box.h"
#include "assets/shapes/coil_spring.h"
#include "assets/shapes/crankshaft.h"
#include "assets/shapes/gear.h"
#include "assets/shapes/organic.h"
#include "assets/shapes/platonic.h"
#include "assets/shapes/round_solids.h"
#include "assets/shapes/saddle.h"
#include "assets/shapes/sheet.h"
#include "assets/shapes/slivers.h"
#include "assets/shapes/teapot.h"
#include "assets/shapes/voxel_solid.h"
#include "engine/math/box.h"
#include "parsed_glb.h"
#include "surface_check.h"

namespace palpate::test {
namespace {

std::vector<int> valences(const TriangleSoup& soup) {
  std::vector<int> valence(soup.positions.size(), 0);
  for (const auto& triangle : soup.triangles) {
    for (const auto corner : triangle) ++valence[corner];
  }
  return valence;
}

Box bounds_of(const TriangleSoup& soup) {
  Box bounds;
  for (const DVec3& p : soup.positions) bounds.grow(p);
  return bounds;
}

double volume(const TriangleSoup& soup) {
  return check_surface(soup).volumes.at(0);
}

TEST(Shapes, SizesFollowTheParameters) {
  EXPECT_EQ(shapes::crankshaft(40).triangles.size(), 450u * 40u);
  EXPECT_EQ(shapes::gear(30).triangles.size(), 300u * 30u);
  EXPECT_EQ(shapes::coil_spring(60, 12).triangles.size(), 2u * 60u * 12u);
  EXPECT_EQ(shapes::teapot(4).triangles.size(), 56u * 16u);
  EXPECT_EQ(shapes::icosphere(1.0, 5).triangles.size(), 20u * 25u);
  EXPECT_EQ(shapes::box({1, 1, 1}, {2, 3, 5}).triangles.size(), 4u * (6u + 15u + 10u));
}

TEST(Shapes, OtherSizesAreClosedAndUnfoldedToo) {
  int index = 0;
  for (const auto& soup : {shapes::crankshaft(40), shapes::crankshaft(160), shapes::gear(12),
                           shapes::gear(40), shapes::coil_spring(200, 9), shapes::organic({9, 8, 7})}) {
    SCOPED_TRACE(index++);
    const SurfaceCheck check = check_surface(soup);
    EXPECT_TRUE(check.closed_manifold());
    EXPECT_GT(check.volumes.at(0), 0.0);
    EXPECT_GT(check.sharpest_edge, -0.9);
  }
}

TEST(Shapes, VolumesComeCloseToTheirFormulas) {
  constexpr double kPi = 3.14159265358979323846;
  EXPECT_NEAR(volume(shapes::icosphere(0.1, 32)), 4.0 / 3.0 * kPi * 1e-3, 5e-6);
  EXPECT_NEAR(volume(shapes::torus(0.1, 0.03, 256, 128)), 2.0 * kPi * kPi * 0.1 * 0.0009, 2e-6);
  EXPECT_NEAR(volume(shapes::cylinder(0.05, 0.2, 256)), kPi * 0.0025 * 0.2, 1e-6);
  EXPECT_NEAR(volume(shapes::box({0.1, 0.2, 0.3}, {3, 4, 5})), 0.006, 1e-9);
}

TEST(Organic, CoarseAndFineAreOneShape) {
  const Box fine = bounds_of(shapes::organic(shapes::kOrganicFine));
  const Box coarse = bounds_of(shapes::organic(shapes::kOrganicCoarse));
  EXPECT_LT(glm::length(fine.low - coarse.low), 0.003);
  EXPECT_LT(glm::length(fine.high - coarse.high), 0.003);
  EXPECT_NEAR(volume(shapes::organic(shapes::kOrganicCoarse)) / volume(shapes::organic()), 1.0, 0.02);
}

TEST(FlushBoxes, TouchInOnePlaneAndShareAnother) {
  const TriangleSoup soup = shapes::flush_boxes();
  TriangleSoup left, right;
  left.positions.assign(soup.positions.begin(), soup.positions.begin() + 8);
  right.positions.assign(soup.positions.begin() + 8, soup.positions.end());
  EXPECT_EQ(bounds_of(left).high.x, bounds_of(right).low.x);
  EXPECT_EQ(bounds_of(left).high.z, bounds_of(right).high.z);
  EXPECT_NE(bounds_of(left).high.y, bounds_of(right).high.y);
}

TEST(Fan, HasTwoVerticesOfItsValence) {
  const auto valence = valences(shapes::fan(200));
  EXPECT_EQ(std::ranges::count(valence, 200), 2);
}

TEST(Slivers, ReachAnAspectNearAMillion) {
  const double worst = worst_aspect(shapes::slivers());
  std::printf("worst aspect %.0f\n", worst);
  EXPECT_GT(worst, 9e5);
  EXPECT_LT(worst, 1e6);
}

TEST(NestedCavities, AlternateWallsFaceTheCavity) {
  auto volumes = check_surface(shapes::nested_cavities()).volumes;
  std::ranges::sort(volumes, {}, [](double v) { return -std::abs(v); });
  ASSERT_EQ(volumes.size(), 4u);
  EXPECT_GT(volumes[0], 0.0);
  EXPECT_LT(volumes[1], 0.0);
  EXPECT_GT(volumes[2], 0.0);
  EXPECT_LT(volumes[3], 0.0);
}

// The neighbours of the middle vertex lie above it along one axis and below it along the other.
TEST(Saddle, MiddleVertexIsASaddle) {
  const TriangleSoup soup = shapes::saddle();
  std::map<std::pair<double, double>, double> top;
  for (const DVec3& p : soup.positions) {
    auto& z = top.try_emplace({p.x, p.y}, p.z).first->second;
    z = std::max(z, p.z);
  }
  const double cell = 0.2 / 24;
  const auto height = [&](double x, double y) {
    return std::ranges::min_element(
               top, {},
               [&](const auto& entry) { return std::hypot(entry.first.first - x, entry.first.second - y); })
        ->second;
  };
  EXPECT_GT(height(cell, 0), height(0, 0));
  EXPECT_GT(height(-cell, 0), height(0, 0));
  EXPECT_LT(height(0, cell), height(0, 0));
  EXPECT_LT(height(0, -cell), height(0, 0));
}

TEST(Voxels, JoinedThroughFacesIsManifoldForManySeeds) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const SurfaceCheck check = check_surface(shapes::voxel_solid(seed));
    EXPECT_TRUE(check.closed_manifold()) << "seed " << seed;
  }
}

TEST(Voxels, SeedsDiffer) {
  EXPECT_NE(shapes::voxel_solid(1).triangles.size(), shapes::voxel_solid(2).triangles.size());
}

TEST(Sheets, AreDoubleSidedWhereTheySaySo) {
  EXPECT_TRUE(shapes::open_sheet().double_sided.empty());
  for (const auto& soup : {shapes::two_sided_sheet(), shapes::mobius_strip()}) {
    ASSERT_EQ(soup.double_sided.size(), soup.triangles.size());
    EXPECT_EQ(std::ranges::count(soup.double_sided, false), 0);
  }
}

TEST(Teapot, KeepsThePoleTrianglesAndTheOpenEdgesOfTheClassic) {
  const SurfaceCheck check = check_surface(shapes::teapot());
  EXPECT_EQ(check.degenerate_triangles, 40u);
  EXPECT_EQ(check.boundary_edges, 200u);
  const DVec3 size = bounds_of(shapes::teapot()).size() / shapes::kTeapotMetresPerUnit;
  EXPECT_NEAR(size.x, 6.434, 1e-5);
  EXPECT_NEAR(size.y, 4.0, 1e-5);
  EXPECT_NEAR(size.z, 3.0, 1e-5);
}

// Largest distance from a vertex of one soup to the nearest of another.
double farthest_vertex(const std::vector<DVec3>& from, const std::vector<DVec3>& to) {
  double farthest = 0.0;
  for (const DVec3& p : from) {
    double nearest = 1e300;
    for (const DVec3& q : to) nearest = std::min(nearest, glm::distance(p, q));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

TEST(Teapot, AgreesWithTheClassicFileVertexByVertex) {
  const char* data = std::getenv("PALPATE_DATA");
  if (data == nullptr) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const TriangleSoup classic = parse_glb(read_file(std::string(data) + "/teapot_5600.glb")).soup;
  auto ours = shapes::teapot().positions;
  for (DVec3& p : ours) p = p / shapes::kTeapotMetresPerUnit + shapes::kTeapotCentre;
  EXPECT_EQ(ours.size(), classic.positions.size());
  EXPECT_LT(farthest_vertex(ours, classic.positions), 2e-6);
  EXPECT_LT(farthest_vertex(classic.positions, ours), 2e-6);
}

}  // namespace
}  // namespace palpate::test
