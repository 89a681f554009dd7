#include "assets/glb_writer.h"

#include <gtest/gtest.h>

#include "assets/catalogue.h"
#include "assets/shapes/box.h"
#include "engine/math/box.h"
#include "parsed_glb.h"

namespace palpate::test {
namespace {

TriangleSoup with_sides(TriangleSoup soup, const std::vector<bool>& double_sided) {
  soup.double_sided = double_sided;
  return soup;
}

TEST(GlbWriter, EveryModelReadsBackAsItWas) {
  for (const Asset& asset : catalogue()) {
    SCOPED_TRACE(asset.name);
    const TriangleSoup soup = asset.make();
    const ParsedGlb glb = parse_glb(glb_bytes(soup, std::string(asset.name)));
    EXPECT_EQ(glb.document["asset"]["version"], "2.0");
    EXPECT_EQ(glb.document["meshes"][0]["name"], asset.name);
    EXPECT_EQ(glb.document["buffers"][0]["byteLength"], glb.binary.size());
    EXPECT_EQ(glb.soup.positions, soup.positions);
    EXPECT_EQ(glb.soup.triangles, soup.triangles);
  }
}

TEST(GlbWriter, BoundsAreExact) {
  for (const Asset& asset : catalogue()) {
    SCOPED_TRACE(asset.name);
    const TriangleSoup soup = asset.make();
    const ParsedGlb glb = parse_glb(glb_bytes(soup, std::string(asset.name)));
    Box bounds;
    for (const DVec3& p : soup.positions) bounds.grow(p);
    const auto& accessor = glb.document["accessors"][0];
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(accessor["min"][axis].get<double>(), bounds.low[axis]);
      EXPECT_EQ(accessor["max"][axis].get<double>(), bounds.high[axis]);
    }
  }
}

TEST(GlbWriter, MixedSidesBecomeTwoPrimitives) {
  std::vector<bool> sides(12, false);
  sides[3] = sides[7] = true;
  const TriangleSoup soup = with_sides(shapes::box({1, 1, 1}), sides);
  const ParsedGlb glb = parse_glb(glb_bytes(soup, "mixed"));
  ASSERT_EQ(glb.document["meshes"][0]["primitives"].size(), 2u);
  ASSERT_EQ(glb.soup.triangles.size(), 12u);
  EXPECT_EQ(glb.soup.triangles[10], soup.triangles[3]);
  EXPECT_EQ(glb.soup.triangles[11], soup.triangles[7]);
  for (std::size_t t = 0; t < 12; ++t) EXPECT_EQ(glb.soup.double_sided[t], t >= 10);
}

TEST(GlbWriter, NameLengthNeverBreaksTheAlignment) {
  for (std::size_t length = 1; length <= 8; ++length) {
    const std::string bytes = glb_bytes(shapes::box({1, 1, 1}), std::string(length, 'n'));
    EXPECT_EQ(bytes.size() % 4, 0u);
    EXPECT_EQ(parse_glb(bytes).soup.triangles.size(), 12u);
  }
}

}  // namespace
}  // namespace palpate::test
