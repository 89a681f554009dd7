// Edges that are nearly parallel: the direction between them is not their common normal, and a certificate
// must not trust that one. Two ridges rock on each other, in and out of a plateau.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/snch/kinetic_front.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 83;
constexpr int kRocks = 60;
constexpr int kTicks = 40;
constexpr double kGap = 0.01;

// A point of a ridge: its height at a place.
struct Crest {
  double x;
  double z;
};

// A solid under a ridge along x. Its triangles come in any order, so that whichever owns a piece of the ridge
// need not own the ends of that piece.
TriangleSoup ridge(const std::vector<Crest>& crests, double half_width, Random& random) {
  TriangleSoup soup;
  for (const Crest& at : crests)
    soup.positions.insert(soup.positions.end(),
                          {{at.x, 0, at.z}, {at.x, -half_width, -1}, {at.x, half_width, -1}});
  const auto end = static_cast<std::uint32_t>(soup.positions.size()) - 3;
  for (std::uint32_t i = 0; i < end; i += 3)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t here = i + k, beside = i + (k + 1) % 3;
      soup.triangles.insert(soup.triangles.end(), {{here, beside, beside + 3}, {here, beside + 3, here + 3}});
    }
  soup.triangles.insert(soup.triangles.end(), {{0, 2, 1}, {end, end + 1, end + 2}});
  for (std::size_t i = soup.triangles.size(); i > 1; --i)
    std::swap(soup.triangles[i - 1], soup.triangles[random.below(i)]);
  return soup;
}

// Between two steps the ridge holds a plateau whose ends are no minima: only the two edges tell of it.
const std::vector<Crest> kSunken{{-1, 0.3 * kGap}, {-0.6, 0.3 * kGap}, {-0.5, 0},
                                 {0.5, 0},         {0.6, 0.3 * kGap},  {1, 0.3 * kGap}};
const std::vector<Crest> kStraight{{-1, 0}, {1, 0}};

// Ridge over ridge, at right angles to the gap but for a small turn.
Pose upside_down(const DVec3& turn) {
  const DMat3 flip{DVec3{1, 0, 0}, DVec3{0, -1, 0}, DVec3{0, 0, -1}};
  return {glm::mat3_cast(glm::angleAxis(glm::length(turn), glm::normalize(turn))) * flip, {0, 0, kGap}};
}

bool same(const LmdSet& one, const LmdSet& other) {
  return std::equal(one.lmds.begin(), one.lmds.end(), other.lmds.begin(), other.lmds.end(),
                    [](const Lmd& x, const Lmd& y) {
                      return x.feature_a == y.feature_a && x.feature_b == y.feature_b &&
                             x.distance == y.distance && x.weight == y.weight;
                    });
}

bool holds_sunken_plateau(const LmdSet& found) {
  return std::any_of(found.lmds.begin(), found.lmds.end(),
                     [](const Lmd& lmd) { return lmd.distance > 0.9 * kGap; });
}

class ParallelEdges : public testing::TestWithParam<double> {};

TEST_P(ParallelEdges, HoldTheirPlateauInEveryTick) {
  Random random(kSeed);
  const double tolerance = GetParam();
  SearchOptions options;
  options.cutoff = 2 * kGap;
  options.parallel_tolerance = tolerance;
  LmdSearch search;
  LmdSet complete, certified;
  int held = 0, gone = 0, different = 0;
  for (int rock = 0; rock < kRocks; ++rock) {
    const auto a = make_model(ridge(kSunken, random.uniform(0.1, 2.0), random)),
               b = make_model(ridge(kStraight, random.uniform(0.1, 2.0), random));
    const DVec3 axis = random.direction(), start = random.direction();
    const double widest = tolerance * std::pow(10.0, random.uniform(-0.5, 1.5));
    KineticFront front;
    for (int tick = 0; tick < kTicks; ++tick) {
      const DVec3 turn = widest * (std::sin(0.3 * tick) * axis + 0.1 * start);
      search.run(*a, *b, upside_down(turn), options, complete);
      front.update(*a, *b, upside_down(turn), options, certified);
      different += !same(complete, certified);
      ++(holds_sunken_plateau(complete) ? held : gone);
    }
  }
  std::printf("seed %d, tolerance %g: %d ticks with the plateau, %d without, %d differ\n",
              static_cast<int>(kSeed), tolerance, held, gone, different);
  EXPECT_EQ(different, 0);
  EXPECT_GT(held, kRocks * kTicks / 10);
  EXPECT_GT(gone, kRocks * kTicks / 10);
}

INSTANTIATE_TEST_SUITE_P(Tolerances, ParallelEdges, testing::Values(1e-6, SearchOptions::kWidestTolerance));

}  // namespace
}  // namespace palpate
