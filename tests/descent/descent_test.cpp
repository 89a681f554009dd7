// Local descent: it ends, it ends in local minima, and it stays with the ones that a search found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "assets/shapes/box.h"
#include "assets/shapes/platonic.h"
#include "engine/base/clock.h"
#include "engine/descent/lmd_tracker.h"
#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 31;

struct Case {
  const char* a;
  const char* b;
  double b_scale;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.a << " - " << c.b;
}

class Descent : public testing::TestWithParam<std::tuple<Case, DescentForm>> {
 protected:
  const Case& models = std::get<0>(GetParam());
  DescentForm form = std::get<1>(GetParam());
};

// From any pair of triangles a descent ends, and what it gives is one of the complete set.
TEST_P(Descent, EndsInMinimaOfTheCompleteSet) {
  const auto a = asset_model(models.a), b = asset_model(models.b, models.b_scale);
  Random random(kSeed);
  LmdSearch search;
  LmdSet complete, followed, seeds;
  SearchOptions options;
  options.cutoff = 0.02;
  for (int i = 0; i < 10; ++i) {
    const Pose pose = place_near(*a, *b, 0.003, random);
    search.run(*a, *b, pose, options, complete);
    LmdTracker tracker(form);
    seeds.clear();
    for (int k = 0; k < 300; ++k) {
      const Feature on_a{FeatureKind::kFace, random.below(a->mesh().triangles.size())};
      const Feature on_b{FeatureKind::kFace, random.below(b->mesh().triangles.size())};
      seeds.lmds.push_back({{}, {}, {}, 0, 0, 0, on_a, on_b});
    }
    tracker.adopt(a->mesh(), b->mesh(), seeds);
    tracker.follow(a->mesh(), b->mesh(), pose, options, options.cutoff, followed);
    EXPECT_LE(tracker.work().steps, 64u * tracker.work().descents);
    for (const Lmd& lmd : followed.lmds) {
      const bool known = std::any_of(complete.lmds.begin(), complete.lmds.end(), [&](const Lmd& other) {
        return glm::length(other.point_a - lmd.point_a) + glm::length(other.point_b - lmd.point_b) < 1e-9;
      });
      EXPECT_TRUE(known) << "pose " << i << " distance " << lmd.distance;
    }
  }
}

// Brought to its own pose a complete set is itself, plateaus and all. The paper's form may leave a minimum
// for a lower one across a barrier within its neighbourhood.
class PolarDescentOnly : public testing::TestWithParam<Case> {};

TEST_P(PolarDescentOnly, StandsStillWhereNothingMoves) {
  const auto a = asset_model(GetParam().a), b = asset_model(GetParam().b, GetParam().b_scale);
  Random random(kSeed + 1);
  LmdSearch search;
  LmdSet complete, followed;
  SearchOptions options;
  options.cutoff = 0.01;
  for (int i = 0; i < 20; ++i) {
    const Pose pose = place_near(*a, *b, 0.004, random);
    search.run(*a, *b, pose, options, complete);
    LmdTracker tracker;
    tracker.adopt(a->mesh(), b->mesh(), complete);
    for (int repeat = 0; repeat < 2; ++repeat) {
      tracker.follow(a->mesh(), b->mesh(), pose, options, options.cutoff, followed);
      ASSERT_EQ(followed.set_count, complete.set_count);
      ASSERT_EQ(followed.lmds.size(), complete.lmds.size());
      for (std::size_t k = 0; k < complete.lmds.size(); ++k) {
        EXPECT_EQ(followed.lmds[k].feature_a, complete.lmds[k].feature_a);
        EXPECT_EQ(followed.lmds[k].feature_b, complete.lmds[k].feature_b);
        EXPECT_NEAR(followed.lmds[k].distance, complete.lmds[k].distance, 1e-15);
        EXPECT_NEAR(followed.lmds[k].weight, complete.lmds[k].weight, 1e-9);
      }
    }
  }
}

// The same seeds with their features forgotten, so that each has to be descended from.
LmdSet forgetful(const Model& a, const Model& b, LmdSet seeds) {
  for (Lmd& lmd : seeds.lmds) {
    lmd.feature_a = {FeatureKind::kFace, triangles_at(a.mesh(), lmd.feature_a).front()};
    lmd.feature_b = {FeatureKind::kFace, triangles_at(b.mesh(), lmd.feature_b).front()};
  }
  return seeds;
}

// A minimum that stays on its features is what a descent from there ends in, bit by bit, at a lower cost.
TEST_P(PolarDescentOnly, StandsWhereADescentWouldEnd) {
  const auto a = asset_model(GetParam().a), b = asset_model(GetParam().b, GetParam().b_scale);
  Random random(kSeed + 3);
  SearchOptions options;
  options.cutoff = 0.01;
  const std::vector<Pose> motion = sliding_motion(*a, *b, options.cutoff, 0.3, 100, random);
  LmdSearch search;
  LmdSet seeds, standing, descended;
  std::uint64_t standing_work = 0, descended_work = 0;
  for (std::size_t tick = 1; tick < motion.size(); ++tick) {
    search.run(*a, *b, motion[tick - 1], options, seeds);
    LmdTracker one, other;
    one.adopt(a->mesh(), b->mesh(), seeds);
    other.adopt(a->mesh(), b->mesh(), forgetful(*a, *b, seeds));
    one.follow(a->mesh(), b->mesh(), motion[tick], options, options.cutoff, standing);
    other.follow(a->mesh(), b->mesh(), motion[tick], options, options.cutoff, descended);
    standing_work += one.work().triangle_pairs;
    descended_work += other.work().triangle_pairs;
    ASSERT_EQ(standing.set_count, descended.set_count) << "tick " << tick;
    ASSERT_EQ(standing.lmds.size(), descended.lmds.size()) << "tick " << tick;
    for (std::size_t k = 0; k < standing.lmds.size(); ++k) {
      EXPECT_EQ(standing.lmds[k].feature_a, descended.lmds[k].feature_a) << "tick " << tick;
      EXPECT_EQ(standing.lmds[k].feature_b, descended.lmds[k].feature_b) << "tick " << tick;
      EXPECT_EQ(standing.lmds[k].point_a, descended.lmds[k].point_a) << "tick " << tick;
      EXPECT_EQ(standing.lmds[k].point_b, descended.lmds[k].point_b) << "tick " << tick;
      EXPECT_EQ(standing.lmds[k].distance, descended.lmds[k].distance) << "tick " << tick;
    }
  }
  std::printf("%s - %s: %llu pairs where minima stand, %llu where they are descended to\n", GetParam().a,
              GetParam().b, static_cast<unsigned long long>(standing_work),
              static_cast<unsigned long long>(descended_work));
  EXPECT_LT(standing_work, descended_work);
}

// A minimum on two edges is reached from four pairs of triangles, from each with another rounding: it is one.
TEST_P(PolarDescentOnly, FindsAMinimumOnceFromAllItsTriangles) {
  const auto a = asset_model(GetParam().a), b = asset_model(GetParam().b, GetParam().b_scale);
  Random random(kSeed + 4);
  SearchOptions options;
  options.cutoff = 0.01;
  LmdSearch search;
  LmdSet complete, followed;
  for (int i = 0; i < 20; ++i) {
    const Pose pose = place_near(*a, *b, 0.004, random);
    search.run(*a, *b, pose, options, complete);
    std::vector<TrianglePair> seeds;
    for (const Lmd& lmd : complete.lmds)
      for (const std::uint32_t in_a : triangles_at(a->mesh(), lmd.feature_a))
        for (const std::uint32_t in_b : triangles_at(b->mesh(), lmd.feature_b)) seeds.push_back({in_a, in_b});
    LmdTracker tracker;
    tracker.adopt(seeds);
    tracker.follow(a->mesh(), b->mesh(), pose, options, options.cutoff, followed);
    EXPECT_EQ(followed.set_count, complete.set_count) << "seed " << kSeed + 4 << " pose " << i;
    EXPECT_EQ(followed.lmds.size(), complete.lmds.size()) << "seed " << kSeed + 4 << " pose " << i;
  }
}

std::vector<std::uint32_t> around(const Mesh& mesh, Feature feature) {
  std::vector<std::uint32_t> triangles;
  const auto append = [&](const Feature& part) {
    for (std::uint32_t t : triangles_at(mesh, part)) triangles.push_back(t);
  };
  if (feature.kind != FeatureKind::kFace)
    append(feature);
  else
    for (std::uint32_t edge : mesh.triangle_edges[feature.index]) append({FeatureKind::kEdge, edge});
  return triangles;
}

// The paper's words and nothing else: measure all pairs of the neighbourhoods, go to the closest.
DescentPoint descended_by_the_book(const DescentPair& pair, DescentPoint point) {
  DescentWork work;
  for (int step = 0; step < kMaxDescentSteps; ++step) {
    DescentPoint closest = point;
    for (std::uint32_t a : around(pair.a(), pair.feature_a(point)))
      for (std::uint32_t b : around(pair.b(), pair.feature_b(point))) {
        const DescentPoint next = pair.measure({a, b}, work);
        if (is_closer(next, closest)) closest = next;
      }
    if (closest.triangles == point.triangles) break;
    point = closest;
  }
  return point;
}

// What it leaves out changes nothing.
class NeighbourhoodDescentOnly : public testing::TestWithParam<Case> {};

TEST_P(NeighbourhoodDescentOnly, EndsWhereThePapersDoes) {
  const auto a = asset_model(GetParam().a), b = asset_model(GetParam().b, GetParam().b_scale);
  Random random(kSeed + 4);
  const Pose pose = place_near(*a, *b, 0.003, random);
  const Placement placement(a->mesh().frame, b->mesh().frame, pose);
  const DescentPair pair(a->mesh(), b->mesh(), placement);
  NeighbourhoodDescent descent;
  DescentWork work;
  for (int i = 0; i < 500; ++i) {
    const TrianglePair start{random.below(a->mesh().triangles.size()),
                             random.below(b->mesh().triangles.size())};
    DescentPoint point = pair.measure(start, work);
    const DescentPoint expected = descended_by_the_book(pair, point);
    descent.descend(pair, point, work);
    EXPECT_NEAR(point.closest.squared_distance, expected.closest.squared_distance, 1e-14) << "start " << i;
  }
  EXPECT_GT(work.steps, 0u);
}

// Along a motion, with a search every 10 ms: what is lost against the complete set, and what it costs.
TEST_P(Descent, FollowsAMotion) {
  const auto a = asset_model(models.a), b = asset_model(models.b, models.b_scale);
  Random random(kSeed + 2);
  const double cutoff = 0.006;
  const std::vector<Pose> motion = sliding_motion(*a, *b, cutoff, 0.1, 300, random);
  LmdSearch search;
  LmdSet complete, followed;
  SearchOptions options;
  options.cutoff = cutoff;
  LmdTracker tracker(form);
  std::size_t wanted = 0, missed = 0;
  double time_us = 0;
  DescentWork work;
  for (std::size_t tick = 0; tick < motion.size(); ++tick) {
    search.run(*a, *b, motion[tick], options, complete);
    if (tick % 10 == 0) tracker.adopt(a->mesh(), b->mesh(), complete);
    const Stopwatch watch;
    tracker.follow(a->mesh(), b->mesh(), motion[tick], options, options.cutoff, followed);
    time_us += watch.elapsed_us();
    work.descents += tracker.work().descents;
    work.steps += tracker.work().steps;
    work.triangle_pairs += tracker.work().triangle_pairs;
    for (const Lmd& lmd : complete.lmds) {
      ++wanted;
      missed += std::none_of(followed.lmds.begin(), followed.lmds.end(), [&](const Lmd& other) {
        return glm::length(other.point_a - lmd.point_a) + glm::length(other.point_b - lmd.point_b) < 1e-9;
      });
    }
    for (const Lmd& lmd : followed.lmds) {
      EXPECT_TRUE(std::any_of(
          complete.lmds.begin(), complete.lmds.end(),
          [&](const Lmd& other) {
            return glm::length(other.point_a - lmd.point_a) + glm::length(other.point_b - lmd.point_b) < 1e-9;
          }))
          << "tick " << tick;
    }
  }
  const auto descents = static_cast<double>(std::max<std::uint64_t>(work.descents, 1));
  std::printf("%s - %s, %s: %zu LMDs wanted, %zu missed; a descent: %.2f steps, %.2f pairs, %.2f us\n",
              models.a, models.b, form == DescentForm::kPolar ? "polar" : "neighbourhood", wanted, missed,
              static_cast<double>(work.steps) / descents, static_cast<double>(work.triangle_pairs) / descents,
              time_us / descents);
  EXPECT_GT(wanted, 0u);
  EXPECT_LT(static_cast<double>(missed), 0.25 * static_cast<double>(wanted));
  if (form == DescentForm::kPolar) {
    EXPECT_LT(static_cast<double>(work.triangle_pairs), 1.05 * descents) << "walks have ended elsewhere";
  }
}

const auto kCases =
    testing::Values(Case{"organic_97k", "organic_2200", 0.4}, Case{"crankshaft_45k", "gear_6k", 0.5},
                    Case{"spring_23k", "teapot_5600", 0.3}, Case{"saddle", "fan_200", 0.5},
                    Case{"slivers", "torus", 0.4}, Case{"voxels", "box_tessellated", 0.3});

INSTANTIATE_TEST_SUITE_P(Assets, Descent,
                         testing::Combine(kCases,
                                          testing::Values(DescentForm::kPolar, DescentForm::kNeighbourhood)));
INSTANTIATE_TEST_SUITE_P(Assets, PolarDescentOnly, kCases);
INSTANTIATE_TEST_SUITE_P(Assets, NeighbourhoodDescentOnly, kCases);

TEST(DescentPlateau, KeepsAllItsPointsWhileItSlides) {
  const auto a = make_model(shapes::box({1, 1, 1}, {6, 6, 6})),
             b = make_model(shapes::box({0.5, 0.5, 0.5}, {3, 3, 3}));
  LmdSearch search;
  LmdSet complete, followed;
  SearchOptions options;
  options.cutoff = 0.05;
  LmdTracker tracker;
  for (int tick = 0; tick < 200; ++tick) {
    const Pose pose{DMat3(1.0), {-0.3 + 0.002 * tick, 0.1 + 0.0005 * tick, 0.78}};
    search.run(*a, *b, pose, options, complete);
    if (tick == 0) tracker.adopt(a->mesh(), b->mesh(), complete);
    tracker.follow(a->mesh(), b->mesh(), pose, options, options.cutoff, followed);
    ASSERT_EQ(followed.set_count, 1u) << tick;
    ASSERT_EQ(followed.lmds.size(), complete.lmds.size()) << tick;
  }
}

// A way around a fine ball takes more steps than one tick has.
TEST(DescentCutShort, GoesOnInTheNextTick) {
  const auto ball = make_model(shapes::icosphere(0.1, 100)), probe = make_model(shapes::icosphere(0.01, 2));
  const Pose pose{glm::mat3_cast(glm::angleAxis(0.4, glm::normalize(DVec3(1, 2, 3)))), {0.07, 0.06, 0.07}};
  LmdSearch search;
  LmdSet complete, followed;
  SearchOptions options;
  options.cutoff = 0.02;
  search.run(*ball, *probe, pose, options, complete);
  ASSERT_EQ(complete.set_count, 1u);
  Random random(kSeed + 5);
  int most_ticks = 0;
  for (int i = 0; i < 50; ++i) {
    const TrianglePair start{random.below(ball->mesh().triangles.size()),
                             random.below(probe->mesh().triangles.size())};
    LmdTracker tracker;
    tracker.adopt(std::span(&start, 1));
    int ticks = 0;
    do {
      tracker.follow(ball->mesh(), probe->mesh(), pose, options, options.cutoff, followed);
    } while (++ticks < 20 && followed.lmds.empty() && tracker.size() > 0);
    most_ticks = std::max(most_ticks, ticks);
    ASSERT_EQ(followed.lmds.size(), 1u) << "seed " << kSeed + 5 << " start " << i;
    EXPECT_EQ(followed.lmds.front().point_a, complete.lmds.front().point_a) << "seed " << kSeed + 5;
  }
  std::printf("seed %llu: up to %d ticks\n", static_cast<unsigned long long>(kSeed + 5), most_ticks);
  EXPECT_GT(most_ticks, 1);
}

TEST(DescentContact, ReportsTouchingInsteadOfAMinimum) {
  const auto a = make_model(shapes::box({1, 1, 1})), b = make_model(shapes::box({0.5, 0.5, 0.5}));
  LmdSearch search;
  LmdSet found;
  SearchOptions options;
  options.cutoff = 0.05;
  LmdTracker tracker;
  const DMat3 tilt = glm::mat3_cast(glm::angleAxis(0.4, glm::normalize(DVec3(1, 2, 0))));
  double height = 0.9;
  search.run(*a, *b, {tilt, {0.05, 0.02, height}}, options, found);
  tracker.adopt(a->mesh(), b->mesh(), found);
  while (height > 0.7) {
    height -= 0.001;
    tracker.follow(a->mesh(), b->mesh(), {tilt, {0.05, 0.02, height}}, options, options.cutoff, found);
    if (found.overlapping()) break;
  }
  EXPECT_TRUE(found.overlapping());
}

}  // namespace
}  // namespace palpate
