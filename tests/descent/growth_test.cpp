// [JW04] figure 3: a descent crosses as many triangles as lie along its way, so their number grows with the
// square root of the number of triangles of the shape.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "assets/shapes/platonic.h"
#include "engine/descent/lmd_tracker.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

TEST(Growth, TrianglesCrossedGrowWithTheSquareRoot) {
  const auto probe = make_model(shapes::icosphere(0.01, 2));
  std::vector<double> log_triangles, log_crossed;
  for (int fineness : {2, 4, 8, 16, 32}) {
    const auto ball = make_model(shapes::icosphere(0.1, 5 * fineness));
    LmdSearch search;
    LmdSet found;
    SearchOptions options;
    options.cutoff = 0.03;
    LmdTracker tracker;
    // One and the same path for all: two turns around the ball in 40 large steps.
    const auto pose_at = [](int tick) {
      const double angle = 0.3 + 0.31 * tick;
      return Pose{DMat3(1.0), 0.118 * DVec3(std::cos(angle), 0.8 * std::sin(angle), 0.6 * std::sin(angle))};
    };
    search.run(*ball, *probe, pose_at(0), options, found);
    tracker.adopt(ball->mesh(), probe->mesh(), found);
    std::uint64_t crossed = 0, descents = 0;
    for (int tick = 1; tick < 40; ++tick) {
      tracker.follow(ball->mesh(), probe->mesh(), pose_at(tick), options, options.cutoff, found);
      crossed += tracker.work().steps;
      descents += tracker.work().descents;
      if (tracker.size() == 0) {
        search.run(*ball, *probe, pose_at(tick), options, found);
        tracker.adopt(ball->mesh(), probe->mesh(), found);
      }
    }
    log_triangles.push_back(std::log(static_cast<double>(ball->mesh().triangles.size())));
    log_crossed.push_back(std::log(static_cast<double>(crossed) / static_cast<double>(descents)));
    std::printf("%zu triangles: %.2f crossed a descent (%llu descents)\n", ball->mesh().triangles.size(),
                std::exp(log_crossed.back()), static_cast<unsigned long long>(descents));
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
