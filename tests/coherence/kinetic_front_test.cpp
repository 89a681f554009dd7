// Certified coherence: in every tick the complete set, at a fraction of a search's work.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "engine/base/clock.h"
#include "engine/snch/kinetic_front.h"
#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 77;

// Pairs of nodes that a tick may test besides, to renew a front that is small.
constexpr std::uint64_t kRenewal = 256;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kTicks = 60;
#else
constexpr int kTicks = 1000;
#endif

struct Case {
  const char* a;
  const char* b;
  double b_scale;
  bool from_data;
  double speed;  // diagonals of A a second
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.a << " - " << c.b << " at " << c.speed;
}

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

class Coherence : public testing::TestWithParam<Case> {};

TEST_P(Coherence, IsTheCompleteSetInEveryTick) {
  const Case& c = GetParam();
  if (c.from_data && !data_folder()) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const auto a = c.from_data ? data_model(c.a) : asset_model(c.a);
  const auto b = c.from_data ? data_model(c.b, c.b_scale) : asset_model(c.b, c.b_scale);
  const double diagonal = a->bounds().diagonal();
  Random random(kSeed);
  SearchOptions options;
  options.cutoff = 0.02 * diagonal;
  const std::vector<Pose> motion = sliding_motion(*a, *b, options.cutoff, c.speed * diagonal, kTicks, random);
  KineticFront front;
  LmdSearch search;
  LmdSet complete, certified;
  std::vector<double> front_us, search_us;
  double expired = 0, entries = 0, triangle_pairs = 0, node_pairs = 0;
  std::size_t sets = 0, different = 0;
  double most_work = 0;  // of a tick but the first, in that of a search from scratch
  for (const Pose& pose : motion) {
    Stopwatch search_watch;
    search.run(*a, *b, pose, options, complete);
    search_us.push_back(search_watch.elapsed_us());
    const Stopwatch watch;
    front.update(*a, *b, pose, options, certified);
    front_us.push_back(watch.elapsed_us());
    entries += static_cast<double>(front.work().entries);
    expired += static_cast<double>(front.work().expired);
    node_pairs += static_cast<double>(certified.work.node_pairs);
    if (&pose != &motion.front())
      most_work = std::max(most_work, static_cast<double>(certified.work.node_pairs) /
                                          static_cast<double>(complete.work.node_pairs + kRenewal));
    triangle_pairs += static_cast<double>(certified.work.triangle_pairs);
    sets += complete.set_count;
    different += complete.lmds.size() != certified.lmds.size() || complete.overlaps != certified.overlaps ||
                 !std::equal(complete.lmds.begin(), complete.lmds.end(), certified.lmds.begin(),
                             [](const Lmd& one, const Lmd& other) {
                               return one.feature_a == other.feature_a && one.feature_b == other.feature_b &&
                                      one.distance == other.distance && one.weight == other.weight;
                             });
  }
  const double n = static_cast<double>(motion.size());
  std::printf(
      "%s - %s at %.2f diagonals/s: %.1f sets; front %.0f entries, %.1f %% expired, %.0f node and %.0f "
      "triangle "
      "pairs a tick; certified median %.0f p99 %.0f us, search median %.0f p99 %.0f us; ticks that differ "
      "%zu; most work of a tick %.2f of a search\n",
      c.a, c.b, c.speed, static_cast<double>(sets) / n, entries / n, 100 * expired / entries, node_pairs / n,
      triangle_pairs / n, quantile(front_us, 0.5), quantile(front_us, 0.99), quantile(search_us, 0.5),
      quantile(search_us, 0.99), different, most_work);
  EXPECT_EQ(different, 0u);
  EXPECT_GT(sets, 0u);
  EXPECT_LT(most_work, 1.0) << "a tick starts afresh";
}

INSTANTIATE_TEST_SUITE_P(Assets, Coherence,
                         testing::Values(Case{"crankshaft_45k", "gear_6k", 0.5, false, 0.3},
                                         Case{"spring_23k", "teapot_5600", 0.3, false, 0.3},
                                         Case{"organic_97k", "organic_2200", 0.4, false, 0.3},
                                         Case{"organic_97k", "organic_2200", 0.4, false, 1.0},
                                         Case{"voxels", "box_tessellated", 0.3, false, 1.0},
                                         Case{"saddle", "fan_200", 0.5, false, 1.0},
                                         Case{"two_sided_sheet", "cylinder", 0.5, false, 1.0},
                                         Case{"open_sheet", "mobius_strip", 0.5, false, 5.0}));

INSTANTIATE_TEST_SUITE_P(Data, Coherence,
                         testing::Values(Case{"horse_outward.glb", "bunny_2200.glb", 0.004, true, 0.33},
                                         Case{"crankshaft_45k.glb", "gear_6k.glb", 0.5, true, 0.33},
                                         Case{"spring_23k.glb", "teapot_5600.glb", 2.0, true, 0.33}));

}  // namespace
}  // namespace palpate
