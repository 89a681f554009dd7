#include "engine/mesh/degenerate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mesh/soups.h"

namespace palpate {
namespace {

// A tetrahedron whose edge along x is cut at different places in the two faces beside it, with slivers
// between. Its vertices: 0 … kLength along that edge, then the two others.
constexpr std::uint32_t kLength = 16, kLeft = kLength + 1, kRight = kLength + 2;

struct CutEdge {
  std::vector<std::uint32_t> left, right;  // places of the cuts, ascending, in (0, kLength)
};

TriangleSoup tetrahedron_positions() {
  TriangleSoup soup;
  for (std::uint32_t x = 0; x <= kLength; ++x) soup.positions.emplace_back(x, 0, 0);
  soup.positions.insert(soup.positions.end(), {{5, 7, 1}, {6, -2, 9}});
  return soup;
}

// The tetrahedron with a hole between its cut edges, and the corners of that hole in the order in which
// slivers that close it run around it.
TriangleSoup cut_tetrahedron(const CutEdge& cut, std::vector<std::uint32_t>& hole) {
  TriangleSoup soup = tetrahedron_positions();
  std::vector<std::uint32_t> left = cut.left, right = cut.right;
  for (auto* side : {&left, &right}) {
    side->insert(side->begin(), 0);
    side->push_back(kLength);
  }
  for (std::size_t i = 0; i + 1 < left.size(); ++i) soup.triangles.push_back({left[i + 1], left[i], kLeft});
  for (std::size_t i = 0; i + 1 < right.size(); ++i)
    soup.triangles.push_back({right[i], right[i + 1], kRight});
  soup.triangles.push_back({0, kRight, kLeft});
  soup.triangles.push_back({kLength, kLeft, kRight});
  hole = left;
  hole.insert(hole.end(), right.rbegin() + 1, right.rend() - 1);
  return soup;
}

// Cuts ears off the hole at the places that `random` draws.
void close_hole(TriangleSoup& soup, std::vector<std::uint32_t> hole, std::mt19937& random) {
  while (hole.size() > 2) {
    const std::size_t i = random() % hole.size();
    const std::size_t last = (i + hole.size() - 1) % hole.size(), next = (i + 1) % hole.size();
    soup.triangles.push_back({hole[last], hole[i], hole[next]});
    hole.erase(hole.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::size_t without_area(const CleanTriangles& surface) {
  return std::ranges::count_if(surface.triangles,
                               [&](const TriangleIndices& t) { return has_no_area(surface.positions, t); });
}

TEST(Degenerate, DropsTrianglesWithEqualCorners) {
  TriangleSoup soup = cube(DVec3(0.0), 1.0);
  soup.triangles.insert(soup.triangles.begin() + 3, {{0, 0, 1}, {1, 2, 1}, {3, 3, 3}});
  soup.positions.push_back(soup.positions[0]);
  soup.triangles.push_back({0, 8, 5});
  const Cleaned result = cleaned(soup);
  EXPECT_EQ(result.report.degenerate_triangles, 4u);
  EXPECT_EQ(result.report.split_triangles, 0u);
  EXPECT_TRUE(result.report.source.watertight());
  EXPECT_TRUE(result.report.final.watertight());
  EXPECT_EQ(result.surface.source[2], 2u);
  EXPECT_EQ(result.surface.source[3], 6u);
  EXPECT_EQ(result.report.notes, std::vector<std::string>{"Dropped 4 triangles without area."});
}

TEST(Degenerate, KeepsATriangleThatIsMerelyThin) {
  TriangleSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-30, 0}};
  soup.triangles = {{0, 1, 2}};
  EXPECT_EQ(cleaned(soup).surface.triangles.size(), 1u);
}

// Their cross products are zero with every mixture of signs.
TEST(Degenerate, FindsSliversInEveryDirection) {
  for (int i = 1; i < 27; ++i) {
    const DVec3 direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (direction == DVec3(0.0)) continue;
    TriangleSoup soup = cube(DVec3(4.0), 1.0);
    for (int step : {0, 3, 1}) soup.positions.push_back(double(step) * direction);
    soup.triangles.push_back({8, 9, 10});
    EXPECT_EQ(cleaned(soup).report.degenerate_triangles, 1u) << i;
  }
}

TEST(Degenerate, SplitsTheNeighbourOfASliver) {
  std::vector<std::uint32_t> hole;
  TriangleSoup soup = cut_tetrahedron({{}, {4}}, hole);
  soup.triangles.push_back({0, kLength, 4});
  soup.double_sided.resize(soup.triangles.size());
  soup.double_sided[0] = true;
  const Cleaned result = cleaned(soup);
  EXPECT_TRUE(result.report.source.watertight());
  EXPECT_TRUE(result.report.final.watertight());
  EXPECT_EQ(result.report.final.orientation, Orientation::kOutward);
  EXPECT_EQ(result.report.degenerate_triangles, 1u);
  EXPECT_EQ(result.report.split_triangles, 1u);
  EXPECT_EQ(result.report.reversed_triangles, 0u);
  EXPECT_EQ(result.surface.triangles.size(), 6u);
  EXPECT_EQ(std::ranges::count(result.surface.source, 0u), 2)
      << "both halves come from the one that was split";
  EXPECT_EQ(result.report.double_sided_triangles, 2u);
  for (std::size_t t = 0; t < 6; ++t)
    EXPECT_EQ(result.surface.double_sided[t], result.surface.source[t] == 0);
}

TEST(Degenerate, SplittingKeepsTheSurface) {
  std::vector<std::uint32_t> hole;
  TriangleSoup soup = cut_tetrahedron({{3, 9}, {4, 5, 12}}, hole);
  const auto solids = static_cast<std::uint32_t>(soup.triangles.size());
  std::mt19937 random(1);
  close_hole(soup, hole, random);
  const Cleaned result = cleaned(soup);
  // A sixth of the triple product of the edges at vertex 0.
  EXPECT_NEAR(enclosed_volume(result.surface, 0, solids), 16 * (7 * 9 + 2 * 1) / 6.0, 1e-9);
}

TEST(Degenerate, ResolvesSliversInEveryOrder) {
  std::vector<std::uint32_t> hole;
  const TriangleSoup solids = cut_tetrahedron({{}, {4, 8, 12}}, hole);
  std::vector<TriangleIndices> slivers = {{0, 8, 4}, {0, 12, 8}, {0, kLength, 12}};
  std::ranges::sort(slivers);
  do {
    TriangleSoup soup = solids;
    soup.triangles.insert(soup.triangles.end(), slivers.begin(), slivers.end());
    const Cleaned result = cleaned(soup);
    EXPECT_TRUE(result.report.final.watertight());
    EXPECT_EQ(result.report.split_triangles, 3u);
    EXPECT_EQ(without_area(result.surface), 0u);
  } while (std::ranges::next_permutation(slivers).found);
}

// Any cuts on either side and any triangulation of what lies between.
TEST(Degenerate, ResolvesRandomTriangulationsOfSlivers) {
  for (std::uint32_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    CutEdge cut;
    for (std::uint32_t x = 1; x < kLength; ++x) {
      const std::uint32_t side = random() % 3;
      if (side == 0) cut.left.push_back(x);
      if (side == 1) cut.right.push_back(x);
    }
    std::vector<std::uint32_t> hole;
    TriangleSoup soup = cut_tetrahedron(cut, hole);
    const std::size_t solids = soup.triangles.size();
    close_hole(soup, hole, random);
    std::ranges::shuffle(soup.triangles, random);
    const Cleaned result = cleaned(soup);
    const std::size_t cuts = cut.left.size() + cut.right.size();
    ASSERT_EQ(result.report.degenerate_triangles, cuts);
    ASSERT_TRUE(result.report.final.watertight());
    ASSERT_EQ(result.surface.triangles.size(), solids + cuts);
    ASSERT_EQ(result.report.split_triangles, cuts);
    ASSERT_EQ(without_area(result.surface), 0u);
    ASSERT_EQ(result.report.final.orientation, Orientation::kOutward);
  }
}

TEST(Degenerate, TwoSliversBackToBackCancel) {
  std::vector<std::uint32_t> hole;
  TriangleSoup soup = cut_tetrahedron({{}, {}}, hole);
  soup.triangles.insert(soup.triangles.end(), {{0, 4, 9}, {0, 9, 4}});
  const Cleaned result = cleaned(soup);
  EXPECT_EQ(result.report.degenerate_triangles, 2u);
  EXPECT_EQ(result.report.split_triangles, 0u);
  EXPECT_TRUE(result.report.final.watertight());
  EXPECT_EQ(result.report.final.vertices, 4u);
}

TEST(Degenerate, DropsASliverAtABoundary) {
  TriangleSoup soup = tetrahedron_positions();
  soup.triangles = {{0, 4, kLeft}, {4, kLength, kLeft}, {4, 0, kLength}};
  const Cleaned result = cleaned(soup);
  EXPECT_EQ(result.report.split_triangles, 0u);
  EXPECT_EQ(result.surface.triangles.size(), 2u);
  EXPECT_EQ(result.report.final.boundary_edges, 4u);
}

TEST(Degenerate, DoesNotChooseBetweenTwoNeighbours) {
  std::vector<std::uint32_t> hole;
  TriangleSoup soup = cut_tetrahedron({{}, {4}}, hole);
  soup.triangles.push_back({0, kLength, 4});
  soup.positions.emplace_back(1, -5, -6);
  soup.triangles.push_back({0, kLength, kRight + 1});
  const Cleaned result = cleaned(soup);
  EXPECT_EQ(result.report.split_triangles, 0u);
  EXPECT_EQ(result.surface.triangles.size(), 6u);
}

}  // namespace
}  // namespace palpate
