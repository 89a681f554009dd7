// Degenerate placements: voxel solids and boxes on one grid, where nearly every minimum is part of a plateau.
// Every pair of triangles whose closest points satisfy the definition must be covered by a set: same
// direction, same distance, within the convex hull of its points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/oracle/oracle.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 5;

// How far a point lies outside the convex hull of points in one plane, in the worst of many directions of
// that plane.
double outside_hull(const DVec3& point, const std::vector<DVec3>& corners, const DVec3& normal) {
  constexpr int kDirections = 360;
  const DVec3 x =
      glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.7 ? DVec3(1, 0, 0) : DVec3(0, 1, 0)));
  const DVec3 y = glm::cross(normal, x);
  double outside = 0.0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const DVec3 direction = x * std::cos(angle) + y * std::sin(angle);
    double reach = -1e300;
    for (const DVec3& corner : corners) reach = std::max(reach, glm::dot(corner, direction));
    outside = std::max(outside, glm::dot(point, direction) - reach);
  }
  return outside;
}

bool covered(const oracle::Closest& wanted, const LmdSet& found, double diagonal) {
  const DVec3 normal = (wanted.on_b - wanted.on_a) / wanted.distance;
  for (std::size_t i = 0, end; i < found.lmds.size(); i = end) {
    std::vector<DVec3> corners;
    for (end = i; end < found.lmds.size() && found.lmds[end].set == found.lmds[i].set; ++end)
      corners.push_back(found.lmds[end].point_a);
    const Lmd& first = found.lmds[i];
    if (std::abs(first.distance - wanted.distance) > 1e-6 * diagonal ||
        glm::dot(first.normal, normal) < 1 - 1e-6)
      continue;
    double extent = 0;
    for (const DVec3& corner : corners) extent = std::max(extent, glm::length(corner - corners.front()));
    const double slack = 1e-5 * diagonal + (corners.size() == 8 ? 0.15 * extent : 0.0);
    if (outside_hull(wanted.on_a, corners, normal) <= slack) return true;
  }
  return false;
}

DMat3 quarter_turns(Random& random) {
  DMat3 turn(1.0);
  for (int i = 0; i < 3; ++i) {
    DMat3 cycle(0.0);
    cycle[0][1] = cycle[1][2] = cycle[2][0] = 1.0;
    DMat3 quarter(1.0);
    quarter[0] = {0, 1, 0};
    quarter[1] = {-1, 0, 0};
    if (random.below(2)) turn = cycle * turn;
    if (random.below(2)) turn = quarter * turn;
  }
  return turn;
}

struct Pair {
  const char* a;
  const char* b;
  double cell;  // metres: positions are multiples of a part of it
};

void PrintTo(const Pair& pair, std::ostream* out) {
  *out << pair.a << " - " << pair.b;
}

class GridPlacement : public testing::TestWithParam<Pair> {};

TEST_P(GridPlacement, CoversEveryMinimumOfThePlateaus) {
  const Pair& pair = GetParam();
  const auto a = asset_model(pair.a), b = asset_model(pair.b);
  const oracle::Surface surface_a(a->mesh()), surface_b(b->mesh());
  const oracle::Oracle oracle(surface_a, surface_b);
  const double diagonal = a->bounds().diagonal(), cutoff = 0.06 * diagonal;
  Random random(kSeed);
  LmdSearch search;
  LmdSet found;
  SearchOptions options;
  options.cutoff = cutoff;
  std::size_t wanted = 0, sets = 0, overlaps = 0, points = 0;
  for (int i = 0; i < 60; ++i) {
    const auto offset = [&] { return pair.cell * (static_cast<double>(random.below(33)) - 16.0) / 2.0; };
    const double gap = random.below(3) == 0 ? 0.0 : random.uniform(0.0, 0.5) * cutoff;
    const Pose pose{quarter_turns(random), DVec3(offset(), offset(), offset()) + random.direction() * gap};
    const oracle::Truth truth = oracle.search(pose, cutoff);
    search.run(*a, *b, pose, options, found);
    const oracle::Oracle::Verdict verdict = oracle.compare(found, truth, pose, cutoff);
    EXPECT_EQ(verdict.first, "") << "placement " << i;
    for (const oracle::Closest& minimum : oracle.weak_minima(pose, cutoff)) {
      ++wanted;
      EXPECT_TRUE(covered(minimum, found, diagonal))
          << "placement " << i << " a(" << minimum.on_a.x << ' ' << minimum.on_a.y << ' ' << minimum.on_a.z
          << ") distance " << minimum.distance << " places " << minimum.place_a.dimension << ' '
          << minimum.place_b.dimension;
    }
    sets += found.set_count;
    points += found.lmds.size();
    overlaps += found.overlapping();
  }
  std::printf(
      "%s - %s: 60 placements on the grid, %zu minima on plateaus or alone, %zu sets of %zu points, %zu "
      "overlap\n",
      pair.a, pair.b, wanted, sets, points, overlaps);
  EXPECT_GT(points, sets) << "there are plateaus";
}

INSTANTIATE_TEST_SUITE_P(Assets, GridPlacement,
                         testing::Values(Pair{"voxels", "box", 0.0125}, Pair{"voxels", "l_bracket", 0.0125},
                                         Pair{"voxels", "voxels", 0.0125},
                                         Pair{"voxels_nonmanifold", "box_tessellated", 0.0125},
                                         Pair{"flush_boxes", "l_bracket", 0.0125},
                                         Pair{"plate", "cylinder", 0.0125}));

}  // namespace
}  // namespace palpate
