#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/oracle/oracle.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 20041;
constexpr double kCutoffs[] = {0.01, 0.03, 0.06};  // of the diagonal of A

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kPoses = 3;
#else
constexpr int kPoses = 50;
#endif

struct Pair {
  const char* a;
  const char* b;
  double b_scale;
  bool from_data;
};

void PrintTo(const Pair& pair, std::ostream* out) {
  *out << pair.a << " - " << pair.b;
}

template <class T>
T median(std::vector<T> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

class CompleteSet : public testing::TestWithParam<Pair> {};

TEST_P(CompleteSet, IsWhatTheDefinitionSays) {
  const Pair& pair = GetParam();
  if (pair.from_data && !data_folder()) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const auto a = pair.from_data ? data_model(pair.a) : asset_model(pair.a);
  const auto b = pair.from_data ? data_model(pair.b, pair.b_scale) : asset_model(pair.b, pair.b_scale);
  const oracle::Surface surface_a(a->mesh()), surface_b(b->mesh());
  const oracle::Oracle oracle(surface_a, surface_b);
  const double diagonal = a->bounds().diagonal();

  Random random(kSeed);
  LmdSearch search;
  LmdSet found;
  oracle::Oracle::Verdict total;
  std::size_t certain = 0, sets = 0, overlaps = 0;
  std::vector<std::uint64_t> node_pairs, triangle_pairs;
  for (int pose_number = 0; pose_number < kPoses; ++pose_number) {
    const bool deep = pose_number % 8 == 7;
    const Pose pose = place_near(*a, *b, diagonal * (deep ? -0.01 : random.uniform(0.0005, 0.02)), random);
    const oracle::Truth truth = oracle.search(pose, kCutoffs[2] * diagonal);
    overlaps += truth.overlap;
    for (double cutoff : kCutoffs) {
      SearchOptions options;
      options.cutoff = cutoff * diagonal;
      search.run(*a, *b, pose, options, found);
      const oracle::Oracle::Verdict verdict = oracle.compare(found, truth, pose, options.cutoff);
      total.missed += verdict.missed;
      total.spurious += verdict.spurious;
      total.wrong_overlap += verdict.wrong_overlap;
      if (!verdict.first.empty())
        ADD_FAILURE() << "seed " << kSeed << " pose " << pose_number << ": " << verdict.first;
      sets += found.set_count;
      node_pairs.push_back(found.work.node_pairs);
      triangle_pairs.push_back(found.work.triangle_pairs);
    }
    certain += truth.certain.size();
  }
  std::printf(
      "%s - %s: %d poses x 3 cutoffs, seed %llu: %zu certain minima at the largest cutoff, %zu sets found, "
      "%zu poses overlap; missed %d, spurious %d, wrong overlap %d; median node pairs %llu, triangle pairs "
      "%llu\n",
      pair.a, pair.b, kPoses, static_cast<unsigned long long>(kSeed), certain, sets, overlaps, total.missed,
      total.spurious, total.wrong_overlap, static_cast<unsigned long long>(median(node_pairs)),
      static_cast<unsigned long long>(median(triangle_pairs)));
  EXPECT_EQ(total.missed, 0);
  EXPECT_EQ(total.spurious, 0);
  EXPECT_EQ(total.wrong_overlap, 0);
  EXPECT_GT(certain, 0u);
}

INSTANTIATE_TEST_SUITE_P(Assets, CompleteSet,
                         testing::Values(Pair{"crankshaft_45k", "gear_6k", 0.5, false},
                                         Pair{"spring_23k", "teapot_5600", 0.3, false},
                                         Pair{"organic_97k", "organic_2200", 0.4, false},
                                         Pair{"helicopter_113k", "organic_2200", 0.2, false},
                                         Pair{"voxels", "box_tessellated", 0.3, false},
                                         Pair{"voxels_nonmanifold", "l_bracket", 0.4, false},
                                         Pair{"saddle", "fan_200", 0.5, false},
                                         Pair{"slivers", "torus", 0.4, false},
                                         Pair{"nested_cavities", "tetrahedron", 0.1, false},
                                         Pair{"open_sheet", "mobius_strip", 0.5, false},
                                         Pair{"two_sided_sheet", "cylinder", 0.5, false}));

INSTANTIATE_TEST_SUITE_P(Data, CompleteSet,
                         testing::Values(Pair{"horse_outward.glb", "bunny_2200.glb", 0.004, true},
                                         Pair{"crankshaft_45k.glb", "gear_6k.glb", 0.5, true},
                                         Pair{"spring_23k.glb", "teapot_5600.glb", 2.0, true},
                                         Pair{"fandisk.glb", "rocker_arm.glb", 2.0, true}));

}  // namespace
}  // namespace palpate
