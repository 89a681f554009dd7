// Near minima along a motion: the kinetic front has those of a search from scratch in every tick, bit for
// bit, and asking for them changes nothing about the local minimum distances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "engine/base/clock.h"
#include "engine/snch/kinetic_front.h"
#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 78;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kTicks = 30;
#else
constexpr int kTicks = 300;
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

template <class Minimum>
bool same(const std::vector<Minimum>& one, const std::vector<Minimum>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const Lmd& a, const Lmd& b) {
    return a.feature_a == b.feature_a && a.feature_b == b.feature_b && a.point_a == b.point_a &&
           a.point_b == b.point_b && a.normal == b.normal && a.distance == b.distance && a.weight == b.weight;
  });
}

// One front along a motion, and what it cost.
class Follower {
 public:
  Follower(const char* name, const SearchOptions& options) : name_(name), options_(options) {}

  const LmdSet& update(const Model& a, const Model& b, const Pose& pose) {
    const Stopwatch watch;
    front_.update(a, b, pose, options_, found_);
    us_.push_back(watch.elapsed_us());
    entries_ += static_cast<double>(front_.work().entries);
    node_pairs_ += static_cast<double>(found_.work.node_pairs);
    triangle_pairs_ += static_cast<double>(found_.work.triangle_pairs);
    sets_ += found_.set_count;
    near_ += static_cast<double>(found_.near_minima.size());
    return found_;
  }

  void print() const {
    const double n = static_cast<double>(us_.size());
    std::printf(
        "  %-8s %6.1f sets, %6.1f near minima; front %6.0f, %5.0f node and %5.0f triangle pairs a tick; "
        "median %5.0f p99 %5.0f us\n",
        name_, sets_ / n, near_ / n, entries_ / n, node_pairs_ / n, triangle_pairs_ / n, quantile(us_, 0.5),
        quantile(us_, 0.99));
  }
  double near_minima() const { return near_; }

 private:
  const char* name_;
  SearchOptions options_;
  KineticFront front_;
  LmdSet found_;
  std::vector<double> us_;
  double entries_ = 0, node_pairs_ = 0, triangle_pairs_ = 0, sets_ = 0, near_ = 0;
};

class NearMinima : public testing::TestWithParam<Case> {};

TEST_P(NearMinima, AreThoseOfASearchInEveryTick) {
  const Case& c = GetParam();
  if (c.from_data && !data_folder()) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const auto a = c.from_data ? data_model(c.a) : asset_model(c.a);
  const auto b = c.from_data ? data_model(c.b, c.b_scale) : asset_model(c.b, c.b_scale);
  const double diagonal = a->bounds().diagonal();
  Random random(kSeed);
  SearchOptions exact;
  exact.cutoff = 0.02 * diagonal;
  SearchOptions near = exact;
  near.near_minima = true;
  const std::vector<Pose> motion = sliding_motion(*a, *b, near.cutoff, c.speed * diagonal, kTicks, random);
  Follower exact_front("springs", exact), near_front("smooth", near);
  LmdSearch search;
  LmdSet searched;
  std::size_t different = 0, different_lmds = 0;
  for (const Pose& pose : motion) {
    search.run(*a, *b, pose, near, searched);
    const LmdSet& kept = near_front.update(*a, *b, pose);
    different += !same(searched.near_minima, kept.near_minima);
    different_lmds +=
        !same(exact_front.update(*a, *b, pose).lmds, kept.lmds) || !same(searched.lmds, kept.lmds);
  }
  std::printf("%s - %s at %.2f diagonals/s, seed %llu\n", c.a, c.b, c.speed,
              static_cast<unsigned long long>(kSeed));
  exact_front.print();
  near_front.print();
  EXPECT_EQ(different, 0u);
  EXPECT_EQ(different_lmds, 0u);
  EXPECT_GT(near_front.near_minima(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Assets, NearMinima,
                         testing::Values(Case{"crankshaft_45k", "gear_6k", 0.5, false, 0.3},
                                         Case{"spring_23k", "teapot_5600", 0.3, false, 0.3},
                                         Case{"organic_97k", "organic_2200", 0.4, false, 0.3},
                                         Case{"voxels", "box_tessellated", 0.3, false, 1.0},
                                         Case{"saddle", "fan_200", 0.5, false, 1.0},
                                         Case{"two_sided_sheet", "cylinder", 0.5, false, 1.0},
                                         Case{"open_sheet", "mobius_strip", 0.5, false, 5.0}));

INSTANTIATE_TEST_SUITE_P(Data, NearMinima,
                         testing::Values(Case{"horse_outward.glb", "bunny_2200.glb", 0.004, true, 0.33},
                                         Case{"crankshaft_45k.glb", "gear_6k.glb", 0.5, true, 0.33},
                                         Case{"spring_23k.glb", "teapot_5600.glb", 2.0, true, 0.33}));

}  // namespace
}  // namespace palpate
