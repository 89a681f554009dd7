// [JW04] figure 3: a descent crosses as many triangles as lie along its way, so their number grows with the
// square root of the number of triangles of the shape. Crossing them is cheap: where the way is short, one
// pair of features is measured, however many there are.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "assets/shapes/platonic.h"
#include "engine/descent/lmd_tracker.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

// Once around a ball, from a search of the first pose on.
DescentWork around(const Model& ball, const Model& probe, double step, int ticks) {
  // Turned, so that nothing is parallel.
  const DMat3 turned = glm::mat3_cast(glm::angleAxis(0.4, glm::normalize(DVec3(1, 2, 3))));
  const auto pose_at = [&](int tick) {
    const double angle = 0.3 + step * tick;
    return Pose{turned, 0.118 * DVec3(std::cos(angle), 0.8 * std::sin(angle), 0.6 * std::sin(angle))};
  };
  LmdSearch search;
  LmdSet found;
  SearchOptions options;
  options.cutoff = 0.03;
  LmdTracker tracker;
  DescentWork work;
  for (int tick = 0; tick < ticks; ++tick) {
    if (tracker.size() == 0) {
      search.run(ball, probe, pose_at(tick), options, found);
      tracker.adopt(ball.mesh(), probe.mesh(), found);
      continue;
    }
    tracker.follow(ball.mesh(), probe.mesh(), pose_at(tick), options, options.cutoff, found);
    work.descents += tracker.work().descents;
    work.steps += tracker.work().steps;
    work.triangle_pairs += tracker.work().triangle_pairs;
  }
  return work;
}

double per_descent(std::uint64_t count, const DescentWork& work) {
  return static_cast<double>(count) / static_cast<double>(work.descents);
}

TEST(Growth, TrianglesCrossedGrowWithTheSquareRoot) {
  const auto probe = make_model(shapes::icosphere(0.01, 2));
  std::vector<double> log_triangles, log_crossed;
  for (int fineness : {2, 4, 8, 16, 32}) {
    const auto ball = make_model(shapes::icosphere(0.1, 5 * fineness));
    const DescentWork large = around(*ball, *probe, 0.31, 40), small = around(*ball, *probe, 0.002, 1000);
    log_triangles.push_back(std::log(static_cast<double>(ball->mesh().triangles.size())));
    log_crossed.push_back(std::log(per_descent(large.steps, large)));
    std::printf("%zu triangles: large steps cross %.2f features; small ones %.2f, and measure %.3f pairs\n",
                ball->mesh().triangles.size(), std::exp(log_crossed.back()), per_descent(small.steps, small),
                per_descent(small.triangle_pairs, small));
    EXPECT_LE(per_descent(small.triangle_pairs, small), 1.02);
  }
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(log_triangles.size());
  for (std::size_t i = 0; i < log_triangles.size(); ++i) {
    x += log_triangles[i];
    y += log_crossed[i];
    xx += log_triangles[i] * log_triangles[i];
    xy += log_triangles[i] * log_crossed[i];
  }
  const double exponent = (n * xy - x * y) / (n * xx - x * x);
  std::printf("fitted exponent %.3f\n", exponent);
  EXPECT_GT(exponent, 0.4);
  EXPECT_LT(exponent, 0.6);
}

}  // namespace
}  // namespace palpate
