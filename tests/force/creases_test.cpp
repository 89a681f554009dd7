// What a surface is apart from how it is cut.
#define GLM_ENABLE_EXPERIMENTAL
#include "engine/mesh/creases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtx/quaternion.hpp>
#include <set>

#include "assets/shapes/box.h"
#include "assets/shapes/platonic.h"
#include "tests/force/wrench_along.h"
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

// A cone of a thousand faces: from one to the next it turns by far less than what counts as straight.
TriangleSoup cone(double height) {
  constexpr std::uint32_t kSides = 1000;
  TriangleSoup soup;
  soup.positions = {{0, 0, height}, {0, 0, -0.5}};
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const double angle = 2.0 * M_PI * k / kSides;
    soup.positions.push_back({std::cos(angle), std::sin(angle), 0});
    soup.triangles.push_back({0, 2 + k, 2 + (k + 1) % kSides});
    soup.triangles.push_back({1, 2 + (k + 1) % kSides, 2 + k});
  }
  return soup;
}

TEST(Creases, TakeATipForACornerHoweverSlightlyItsFacesTurn) {
  for (const double height : {0.0, 1e-5, 1e-3, 1e-2, -1e-3}) {
    const auto model = make_model(cone(height));
    const Creases creases(model->mesh());
    std::uint32_t tip = 0;
    for (std::uint32_t v = 0; v < model->mesh().positions.size(); ++v) {
      const DVec3 position = model->mesh().position(v);
      if (position.x == 0 && position.y == 0 && model->mesh().frame.metres(position).z > -0.4) tip = v;
    }
    EXPECT_EQ(creases.is_corner(tip), std::abs(height) > 1e-4) << height;
  }
}

// The force of a corner that passes over the tip does not vanish there, and does not jump from side to side
// of a dent.
TEST(Creases, OfACommonTipLetTheForcePass) {
  constexpr double kCutoff = 0.05;
  const auto corner = make_model(shapes::tetrahedron(0.1));
  const DVec3 lowest = corner->mesh().frame.metres(corner->mesh().position(0));
  constexpr int kSteps = 16;
  for (const double height : {1e-3, -1e-2}) {
    const auto model = make_model(cone(height));
    const DMat3 down = glm::mat3_cast(glm::rotation(glm::normalize(lowest), DVec3(0, 0, -1)));
    const Motion over = [&](double t) {
      return Pose{down, DVec3(1e-3 * (t - 0.5), 1.7e-4 * (t - 0.5), height + 0.4 * kCutoff) - down * lowest};
    };
    const auto wrenches = wrenches_along(*model, *corner, over, kSteps, kCutoff, ForceLaw::kSmooth);
    for (const Wrench& wrench : wrenches) EXPECT_NEAR(wrench.force.z, 0.6, 0.02) << height;
    for (int i = 0; i < kSteps; ++i)
      EXPECT_LT(jump_between(*model, *corner, over, i / double(kSteps), (i + 1) / double(kSteps), kCutoff,
                             ForceLaw::kSmooth),
                1e-4)
          << height;
  }
}

}  // namespace
}  // namespace palpate
