// The work of a tick does not grow with the triangles of a surface that stays the same: of what lies under a
// coarse triangle only what faces one of its features is left.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "assets/shapes/organic.h"
#include "engine/snch/kinetic_front.h"
#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 79;
constexpr int kTicks = 60;
constexpr int kFirst = 10;  // the search from scratch, and what it leaves to be certified, are not counted
constexpr double kToolScale = 0.4;

// About so many triangles of one shape.
TriangleSoup organic_of(double triangles) {
  const double per_side = std::sqrt(triangles / 97000.0);
  shapes::Divisions divisions = shapes::kOrganicFine;
  for (auto& cells : divisions) cells = static_cast<int>(std::lround(per_side * cells));
  return shapes::organic(divisions);
}

struct Work {
  double node_pairs = 0.0;
  double triangle_pairs = 0.0;
};

Work work_a_tick(const Model& shape, const Model& tool, const SearchOptions& options,
                 const std::vector<Pose>& motion) {
  KineticFront front;
  LmdSet found;
  Work work;
  for (int tick = 0; tick < kTicks; ++tick) {
    front.update(shape, tool, motion[static_cast<std::size_t>(tick)], options, found);
    if (tick < kFirst) continue;
    work.node_pairs += static_cast<double>(found.work.node_pairs) / (kTicks - kFirst);
    work.triangle_pairs += static_cast<double>(found.work.triangle_pairs) / (kTicks - kFirst);
  }
  return work;
}

TEST(CoherenceGrowth, ACoarseToolCostsTheSameOverAFinerSurface) {
  const auto coarse = make_model(organic_of(10e3)), fine = make_model(organic_of(640e3));
  const auto tool = make_model(scaled(organic_of(2200), kToolScale));
  SearchOptions options;
  options.cutoff = 0.02 * coarse->bounds().diagonal();
  Random random(kSeed);
  const std::vector<Pose> motion =
      sliding_motion(*coarse, *tool, options.cutoff, 0.33 * coarse->bounds().diagonal(), kTicks, random);
  const Work few = work_a_tick(*coarse, *tool, options, motion),
             many = work_a_tick(*fine, *tool, options, motion);
  std::printf(
      "seed %d: %.0f node and %.0f triangle pairs a tick over 10,000 triangles, %.0f and %.0f over 640,000\n",
      static_cast<int>(kSeed), few.node_pairs, few.triangle_pairs, many.node_pairs, many.triangle_pairs);
  EXPECT_LT(many.node_pairs, 4 * few.node_pairs);
  EXPECT_LT(many.triangle_pairs, 2 * few.triangle_pairs);
}

}  // namespace
}  // namespace palpate
