// What a surface is apart from how it is cut.
#include "engine/mesh/creases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "assets/shapes/box.h"
#include "tests/support/models.h"

namespace palpate {
namespace {

// A prism over a regular polygon whose floor and roof are cut into rings.
TriangleSoup drum(std::uint32_t sides, std::uint32_t rings) {
  TriangleSoup soup;
  const auto at = [&](double radius, std::uint32_t k, double z) {
    const double angle = 2.0 * M_PI * (k % sides) / sides;
    return DVec3(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  const auto quad = [&](const DVec3& a, const DVec3& b, const DVec3& c, const DVec3& d) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), {a, b, c, d});
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.triangles.push_back({first, first + 2, first + 3});
  };
  for (std::uint32_t k = 0; k < sides; ++k) {
    quad(at(1, k, -1), at(1, k + 1, -1), at(1, k + 1, 1), at(1, k, 1));
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
      const double inner = static_cast<double>(ring) / rings, outer = (ring + 1.0) / rings;
      quad(at(outer, k, 1), at(outer, k + 1, 1), at(inner, k + 1, 1), at(inner, k, 1));
      quad(at(inner, k, -1), at(inner, k + 1, -1), at(outer, k + 1, -1), at(outer, k, -1));
    }
  }
  return soup;
}

TEST(Creases, KnowTheBordersOfFinelyCutPatches) {
  const auto model = make_model(shapes::box({1, 2, 3}, {6, 7, 8}));
  const Creases creases(model->mesh());
  std::set<std::uint32_t> patches, lines;
  for (std::uint32_t t = 0; t < model->mesh().triangles.size(); ++t) {
    EXPECT_EQ(creases.borders_around(t).size(), 4u);
    patches.insert(creases.patch[t]);
    for (const Creases::Border& border : creases.borders_around(t)) {
      EXPECT_EQ(border.patch, creases.patch[t]);
      lines.insert(border.line);
    }
  }
  EXPECT_EQ(patches.size(), 6u);
  EXPECT_EQ(lines.size(), 12u);
}

TEST(Creases, KnowNoneOfPatchesThatAreWalkedThrough) {
  const auto model = make_model(shapes::box({1, 2, 3}, {4, 8, 4}));  // 64 and 32 triangles to a face
  EXPECT_TRUE(Creases(model->mesh()).borders.empty());
}

TEST(Creases, KnowNoneOfPatchesWithMoreThanHundredsOfLines) {
  for (const std::uint32_t sides : {256u, 257u}) {
    const auto model = make_model(drum(sides, 3));
    const Creases creases(model->mesh());
    EXPECT_EQ(creases.borders.size(), sides > Creases::kMostBorders ? 0u : 2u * sides);
  }
}

}  // namespace
}  // namespace palpate
