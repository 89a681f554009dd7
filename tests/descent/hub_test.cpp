// Descents around vertices of hundreds of faces.
#include <gtest/gtest.h>

#include <cstdio>

#include "assets/shapes/platonic.h"
#include "assets/shapes/round_solids.h"
#include "engine/descent/lmd_tracker.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 53;

Pose pose_beside(double distance, Random& random) {
  return {random.rotation(), distance * random.direction()};
}

TrianglePair any_triangles(const Model& a, const Model& b, Random& random) {
  return {random.below(a.mesh().triangles.size()), random.below(b.mesh().triangles.size())};
}

struct Steps {
  double mean;
  int most;
  int cut_short;  // descents
};

// From triangles at random, until a descent ends or is cut short.
Steps steps_between(const Model& a, const Model& b, double distance, int descents) {
  Random random(kSeed);
  Steps steps{0.0, 0, 0};
  for (int i = 0; i < descents; ++i) {
    const Pose pose = pose_beside(distance, random);
    const Placement placement(a.mesh().frame, b.mesh().frame, pose);
    const DescentPair pair(a.mesh(), b.mesh(), placement);
    DescentWork work;
    DescentPoint point = pair.measure(any_triangles(a, b, random), work);
    steps.cut_short += !PolarDescent().descend(pair, point, work);
    steps.mean += static_cast<double>(work.steps) / descents;
    steps.most = std::max(steps.most, static_cast<int>(work.steps));
  }
  return steps;
}

// One by one, hundreds of a thousand slivers would have to be crossed.
TEST(Hub, IsCrossedInFewSteps) {
  const auto ball = make_model(shapes::icosphere(0.03, 3));
  for (const int valence : {20, 100, 300, 1000}) {
    const Steps steps = steps_between(*make_model(shapes::fan(valence)), *ball, 0.15, 200);
    std::printf("seed %llu, valence %d: %.1f steps a descent, %d at most\n",
                static_cast<unsigned long long>(kSeed), valence, steps.mean, steps.most);
    EXPECT_EQ(steps.cut_short, 0) << "valence " << valence;
    EXPECT_LT(steps.mean, 16.0) << "valence " << valence;
  }
}

TEST(Hub, IsCrossedInFewStepsBesideAnother) {
  for (const int valence : {100, 300, 1000}) {
    const auto fan = make_model(shapes::fan(valence));
    const Steps steps = steps_between(*fan, *fan, 0.22, 200);
    std::printf("seed %llu, valence %d beside the same: %.1f steps a descent, %d at most, %d cut short\n",
                static_cast<unsigned long long>(kSeed), valence, steps.mean, steps.most, steps.cut_short);
    EXPECT_LE(steps.cut_short, 4) << "valence " << valence;
    EXPECT_LT(steps.mean, 32.0) << "valence " << valence;
  }
}

}  // namespace
}  // namespace palpate
