// Work, not time, is asserted; times are printed for the record.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "engine/base/clock.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 97;
constexpr int kPoses = 200;
constexpr double kCutoff = 0.02;  // of the diagonal of A

template <class T>
T quantile(std::vector<T> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

struct Pair {
  const char* a;
  const char* b;
  double b_scale;
  std::uint64_t max_node_pairs;
  std::uint64_t max_triangle_pairs;
};

void PrintTo(const Pair& pair, std::ostream* out) {
  *out << pair.a << " - " << pair.b;
}

class Work : public testing::TestWithParam<Pair> {};

TEST_P(Work, StaysWithinItsBounds) {
  if (!data_folder()) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const Pair& pair = GetParam();
  const auto a = data_model(pair.a), b = data_model(pair.b, pair.b_scale);
  const double diagonal = a->bounds().diagonal();
  Random random(kSeed);
  LmdSearch search;
  LmdSet found;
  SearchOptions options;
  options.cutoff = kCutoff * diagonal;
  std::vector<double> times;
  std::vector<std::uint64_t> node_pairs, triangle_pairs, sets;
  for (int i = 0; i < kPoses; ++i) {
    const Pose pose = place_near(*a, *b, diagonal * random.uniform(0.0005, 0.015), random);
    const Stopwatch watch;
    search.run(*a, *b, pose, options, found);
    times.push_back(watch.elapsed_us());
    node_pairs.push_back(found.work.node_pairs);
    triangle_pairs.push_back(found.work.triangle_pairs);
    sets.push_back(found.set_count);
  }
  const auto triangles = static_cast<double>(a->mesh().triangles.size());
  std::printf(
      "%s - %s, %d poses: node pairs %llu, triangle pairs %llu, sets %llu (medians); search median %.0f us, "
      "p99 %.0f us; %s: tree built in %.1f ms, %.0f + %.0f bytes a triangle (tree + mesh)\n",
      pair.a, pair.b, kPoses, static_cast<unsigned long long>(quantile(node_pairs, 0.5)),
      static_cast<unsigned long long>(quantile(triangle_pairs, 0.5)),
      static_cast<unsigned long long>(quantile(sets, 0.5)), quantile(times, 0.5), quantile(times, 0.99),
      pair.a, a->tree().build_us() / 1000, static_cast<double>(a->tree().bytes()) / triangles,
      static_cast<double>(a->mesh().bytes()) / triangles);
  EXPECT_LT(quantile(node_pairs, 0.5), pair.max_node_pairs);
  EXPECT_LT(quantile(triangle_pairs, 0.5), pair.max_triangle_pairs);
}

INSTANTIATE_TEST_SUITE_P(Data, Work,
                         testing::Values(Pair{"horse_outward.glb", "bunny_2200.glb", 0.004, 20000, 3000},
                                         Pair{"crankshaft_45k.glb", "gear_6k.glb", 0.5, 20000, 3000},
                                         Pair{"spring_23k.glb", "teapot_5600.glb", 2.0, 20000, 3000},
                                         Pair{"fandisk.glb", "rocker_arm.glb", 2.0, 20000, 3000}));

}  // namespace
}  // namespace palpate
