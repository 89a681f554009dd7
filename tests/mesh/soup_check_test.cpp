#include "engine/mesh/soup_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/mesh/soups.h"

namespace palpate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Error error_of(const TriangleSoup& soup, const MeshOptions& options = {}) {
  MeshReport report;
  const Result<CleanTriangles> result = clean_triangles(soup, options, report);
  return result ? Error{ErrorCode::kInternal, "no error"} : result.error();
}

TEST(SoupCheck, NamesTheVertexAndTriangleOfANonFinitePosition) {
  for (double bad : {kNan, kInfinity, -kInfinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      TriangleSoup soup = cube(DVec3(0.0), 1.0);
      soup.positions[7][axis] = bad;
      const Error error = error_of(soup);
      EXPECT_EQ(error.code, ErrorCode::kNonFinite);
      EXPECT_EQ(error.message, "Vertex 7, which triangle 2 uses, has a position that is not finite.");
    }
  }
}

TEST(SoupCheck, IgnoresPositionsThatNoTriangleUses) {
  TriangleSoup soup = cube(DVec3(0.0), 1.0);
  soup.positions.emplace_back(kNan, 0.0, 0.0);
  soup.positions.emplace_back(1e9, 0.0, 0.0);
  const Cleaned result = cleaned(soup);
  EXPECT_EQ(result.report.stored_vertices, 10u);
  EXPECT_EQ(result.report.source.vertices, 8u);
  EXPECT_EQ(result.surface.positions.size(), 8u);
  EXPECT_EQ(result.surface.frame.scale, 4.0);
}

TEST(SoupCheck, NamesTheTriangleOfAnIndexOutOfRange) {
  TriangleSoup soup = cube(DVec3(0.0), 1.0);
  soup.triangles[5][2] = 8;
  const Error error = error_of(soup);
  EXPECT_EQ(error.code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(error.message, "Triangle 5 uses vertex 8, but there are only 8 vertices.");
}

TEST(SoupCheck, RefusesABadTolerance) {
  for (double bad : {-1e-9, kNan, kInfinity}) {
    MeshOptions options;
    options.weld_tolerance = bad;
    EXPECT_EQ(error_of(cube(DVec3(0.0), 1.0), options).code, ErrorCode::kInvalidArgument);
  }
}

TEST(SoupCheck, RefusesTheWrongNumberOfFlags) {
  TriangleSoup soup = cube(DVec3(0.0), 1.0);
  soup.double_sided.resize(11);
  EXPECT_EQ(error_of(soup).code, ErrorCode::kInvalidArgument);
}

TEST(SoupCheck, RefusesAModelWithoutTriangles) {
  EXPECT_EQ(error_of({}).code, ErrorCode::kNoTriangles);
  TriangleSoup point = cube(DVec3(1.0), 0.0);
  EXPECT_EQ(error_of(point).code, ErrorCode::kNoTriangles);
  TriangleSoup line;
  line.positions = {DVec3(0.0), DVec3(1.0), DVec3(3.0)};
  line.triangles = {{0, 1, 2}};
  EXPECT_EQ(error_of(line).code, ErrorCode::kNoTriangles);
}

TEST(SoupCheck, RefusesAnExtentThatOverflows) {
  EXPECT_EQ(error_of(cube(DVec3(0.0), 1e308)).code, ErrorCode::kNonFinite);
}

TEST(SoupCheck, TakesAnyScale) {
  for (double scale : {1e-140, 1e-30, 1e-6, 1e6, 1e30, 1e140}) {
    const Cleaned result = cleaned(cube(DVec3(0.0), scale));
    EXPECT_TRUE(result.report.final.watertight()) << scale;
    EXPECT_EQ(result.surface.triangles.size(), 12u) << scale;
  }
}

}  // namespace
}  // namespace palpate
