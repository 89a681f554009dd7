#include "engine/mesh/nesting.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mesh/soups.h"

namespace palpate {
namespace {

// The facings of `parts` after cleaning: o for outward, i for inward.
std::string final_facings(const std::vector<TriangleSoup>& parts) {
  const Cleaned result = cleaned(joined(parts));
  std::string facings;
  std::uint32_t begin = 0;
  for (const TriangleSoup& part : parts) {
    const auto end = begin + static_cast<std::uint32_t>(part.triangles.size());
    facings += enclosed_volume(result.surface, begin, end) > 0 ? 'o' : 'i';
    begin = end;
  }
  return facings;
}

TriangleSoup facing(const TriangleSoup& soup, char facing) {
  return facing == 'o' ? soup : reversed(soup);
}

// Balls inside each other, the outermost first, that face as `facings` says.
std::vector<TriangleSoup> onion(const std::string& facings) {
  std::vector<TriangleSoup> balls;
  double radius = 1.0;
  for (char c : facings) {
    balls.push_back(facing(ball(DVec3(0.1), radius), c));
    radius *= 0.6;
  }
  return balls;
}

TEST(Nesting, OfTwoShellsInEveryFacing) {
  EXPECT_EQ(final_facings(onion("oo")), "oo") << "a part inside a part";
  EXPECT_EQ(final_facings(onion("oi")), "oi") << "a cavity";
  EXPECT_EQ(final_facings(onion("io")), "oi") << "a cavity of a model that came inside out";
  EXPECT_EQ(final_facings(onion("ii")), "oi") << "an inward one stays a cavity";
}

TEST(Nesting, OfThreeShellsInEveryFacing) {
  EXPECT_EQ(final_facings(onion("ooo")), "ooo");
  EXPECT_EQ(final_facings(onion("ooi")), "ooi");
  EXPECT_EQ(final_facings(onion("oio")), "oio") << "a solid in a cavity";
  EXPECT_EQ(final_facings(onion("oii")), "oio");
  EXPECT_EQ(final_facings(onion("ioo")), "oio");
  EXPECT_EQ(final_facings(onion("ioi")), "oio") << "a solid in a cavity, all inside out";
  EXPECT_EQ(final_facings(onion("iio")), "oio");
  EXPECT_EQ(final_facings(onion("iii")), "oio");
}

TEST(Nesting, DoesNotDependOnTheOrderOfShells) {
  for (const char* facings : {"oio", "ioi", "iioo", "oiio"}) {
    std::vector<TriangleSoup> shells = onion(facings);
    std::string expected = final_facings(shells);
    std::reverse(shells.begin(), shells.end());
    std::reverse(expected.begin(), expected.end());
    EXPECT_EQ(final_facings(shells), expected);
  }
}

TEST(Nesting, AShellInTheHoleOfATorusIsNotInsideIt) {
  const TriangleSoup ring = torus(2.0, 0.5);
  EXPECT_EQ(final_facings({ring, reversed(ball(DVec3(0.0), 0.4))}), "oo");
  EXPECT_EQ(final_facings({ring, reversed(ball(DVec3(2, 0, 0), 0.1))}), "oi") << "and one in its tube is";
}

TEST(Nesting, SiblingsDoNotContainEachOther) {
  const TriangleSoup outer = cube(DVec3(0.0), 10.0);
  EXPECT_EQ(final_facings({outer, reversed(ball(DVec3(-5, 0, 0), 1.0)), reversed(ball(DVec3(5, 0, 0), 2.0)),
                           ball(DVec3(0, 5, 0), 1.0)}),
            "oiio");
}

TEST(Nesting, TakesTheInnermostContainer) {
  // The part in the cavity differs from the cavity, not from the outer shell.
  const TriangleSoup outer = cube(DVec3(0.0), 10.0), cavity = reversed(cube(DVec3(1.0), 5.0));
  const TriangleSoup solid = cube(DVec3(1.0), 2.0), hollow = reversed(cube(DVec3(1.5), 1.0));
  EXPECT_EQ(final_facings({hollow, cavity, outer, solid}), "iioo");
  EXPECT_EQ(final_facings({reversed(hollow), reversed(cavity), reversed(outer), reversed(solid)}), "iioo");
}

TEST(Nesting, ShellsWithEqualBoxes) {
  TriangleSoup octahedron;
  octahedron.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                          {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  EXPECT_EQ(final_facings({cube(DVec3(0.0), 1.0), reversed(octahedron)}), "oi");
  EXPECT_EQ(final_facings({reversed(octahedron), cube(DVec3(0.0), 1.0)}), "io");
}

TEST(Nesting, OpenSurfacesContainNothing) {
  TriangleSoup open = ball(DVec3(0.0), 1.0);
  open.triangles.pop_back();
  EXPECT_EQ(final_facings({open, reversed(ball(DVec3(0.0), 0.5))}), "oo");
}

TEST(Nesting, CountsWhatItTurned) {
  const Cleaned result = cleaned(joined(onion("ioo")));
  EXPECT_EQ(result.report.flipped_components, 2u);
  const std::uint64_t a_ball = ball(DVec3(0.0), 1.0).triangles.size();
  EXPECT_EQ(result.report.reversed_triangles, 2 * a_ball);
}

// Thousands of cavities in one shell, and a grid of thousands beside each other.
TEST(Nesting, OfThousandsOfShells) {
  std::vector<TriangleSoup> shells = {cube(DVec3(0.0), 10.0)};
  std::string expected = "o";
  for (int i = 0; i < 15 * 15 * 15; ++i) {
    const DVec3 centre = DVec3(i % 15 - 7, i / 15 % 15 - 7, i / 225 - 7) * 1.2;
    shells.push_back(facing(cube(centre, 0.5), i % 3 == 0 ? 'i' : 'o'));
    expected += i % 3 == 0 ? 'i' : 'o';
  }
  EXPECT_EQ(final_facings(shells), expected);
  EXPECT_EQ(cleaned(joined(shells)).report.flipped_components, 0u);
  shells.erase(shells.begin());
  EXPECT_EQ(cleaned(joined(shells)).report.flipped_components, 15u * 15 * 15 / 3);
}

}  // namespace
}  // namespace palpate
