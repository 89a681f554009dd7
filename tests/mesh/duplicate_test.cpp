#include "engine/mesh/duplicate.h"

#include <gtest/gtest.h>

#include "tests/mesh/soups.h"

namespace palpate {
namespace {

TriangleSoup cube_with(const TriangleIndices& extra) {
  TriangleSoup soup = cube(DVec3(0.0), 1.0);
  soup.triangles.push_back(extra);
  return soup;
}

TEST(Duplicate, DropsEveryRotation) {
  const TriangleIndices first = cube(DVec3(0.0), 1.0).triangles[4];
  for (int k = 0; k < 3; ++k) {
    const Cleaned result = cleaned(cube_with({first[k], first[(k + 1) % 3], first[(k + 2) % 3]}));
    EXPECT_EQ(result.report.duplicate_triangles, 1u);
    EXPECT_EQ(result.report.double_sided_triangles, 0u);
    EXPECT_TRUE(result.report.final.watertight());
    EXPECT_EQ(result.surface.source.back(), 11u) << "the earlier one is kept";
  }
}

TEST(Duplicate, OppositeWindingMakesTheKeptOneDoubleSided) {
  const TriangleIndices first = cube(DVec3(0.0), 1.0).triangles[4];
  for (int k = 0; k < 3; ++k) {
    const Cleaned result = cleaned(cube_with({first[(k + 2) % 3], first[(k + 1) % 3], first[k]}));
    EXPECT_EQ(result.report.duplicate_triangles, 1u);
    EXPECT_EQ(result.report.double_sided_triangles, 1u);
    EXPECT_TRUE(result.surface.double_sided[4]);
  }
}

TEST(Duplicate, InheritsDoubleSidedness) {
  TriangleSoup soup = cube_with(cube(DVec3(0.0), 1.0).triangles[6]);
  soup.double_sided.assign(13, false);
  soup.double_sided[12] = true;
  const Cleaned result = cleaned(soup);
  EXPECT_TRUE(result.surface.double_sided[6]);
  EXPECT_EQ(result.report.double_sided_triangles, 1u);
}

TEST(Duplicate, ASheetOfTwoLayersBecomesOneDoubleSided) {
  TriangleSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}};
  const Cleaned result = cleaned(soup);
  EXPECT_EQ(result.surface.triangles.size(), 2u);
  EXPECT_EQ(result.report.double_sided_triangles, 2u);
  EXPECT_EQ(result.report.duplicate_triangles, 2u);
  EXPECT_EQ(result.report.final.boundary_edges, 4u);
}

TEST(Duplicate, CountsEveryCopy) {
  const TriangleSoup shape = ball(DVec3(0.0), 1.0);
  const Cleaned result = cleaned(joined({shape, shape, shape}));
  EXPECT_EQ(result.report.duplicate_triangles, 2 * shape.triangles.size());
  EXPECT_EQ(result.report.source.vertices, shape.positions.size());
  EXPECT_TRUE(result.report.final.watertight());
}

TEST(Duplicate, KeepsTrianglesThatShareOnlyTwoVertices) {
  TriangleSoup book;
  book.positions = {{0, 0, 0}, {0, 0, 1}};
  for (std::uint32_t page = 2; page < 50; ++page) {
    book.positions.emplace_back(1, page, 0);
    book.triangles.push_back({0, 1, page});
  }
  const Cleaned result = cleaned(book);
  EXPECT_EQ(result.report.duplicate_triangles, 0u);
  EXPECT_EQ(result.report.final.nonmanifold_edges, 1u);
  EXPECT_EQ(result.surface.triangles.size(), 48u);
}

TEST(Duplicate, AllDoubleSidedIsAnOption) {
  MeshOptions options;
  options.all_double_sided = true;
  EXPECT_EQ(cleaned(cube(DVec3(0.0), 1.0), options).report.double_sided_triangles, 12u);
}

}  // namespace
}  // namespace palpate
