// The smooth law's force is that of the shape, not of its triangles.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "assets/shapes/box.h"
#include "assets/shapes/gear.h"
#include "assets/shapes/platonic.h"
#include "tests/force/shapes.h"
#include "tests/force/wrench_along.h"
#include "tests/support/models.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 31;
constexpr double kSame = 0.02;  // of what one spring can push

// The largest difference of wrenches over a motion.
double difference(const char* name, const Model& a, const Model& b, const Model& other_a,
                  const Model& other_b, double cutoff, const Motion& motion) {
  const auto one = wrenches_along(a, b, motion, 200, cutoff, ForceLaw::kSmooth);
  const auto other = wrenches_along(other_a, other_b, motion, 200, cutoff, ForceLaw::kSmooth);
  double pushed = 0.0;
  for (const Wrench& wrench : one) pushed = std::max(pushed, glm::length(wrench.force));
  const double most = largest_difference(one, other);
  std::printf("%-32s largest difference %.2e of k·c, largest force %.3f\n", name, most, pushed);
  EXPECT_GT(pushed, 0.05) << name;
  return most;
}

// Both models cut sixteen times as fine.
void expect_same_when_refined(const char* name, const TriangleSoup& a, const TriangleSoup& b, double cutoff,
                              double way, int motions) {
  using shapes::refined;
  const auto coarse_a = make_model(a), coarse_b = make_model(b);
  const auto fine_a = make_model(refined(refined(a))), fine_b = make_model(refined(refined(b)));
  Random random(kSeed);
  for (int i = 0; i < motions; ++i)
    EXPECT_LT(difference(name, *coarse_a, *coarse_b, *fine_a, *fine_b, cutoff,
                         drift(*coarse_a, *coarse_b, cutoff, way, random)),
              kSame);
}

TEST(Tessellation, Boxes) {
  expect_same_when_refined("boxes", shapes::box({1, 0.8, 0.6}), shapes::box({0.5, 0.4, 0.3}), 0.1, 0.04, 4);
}

TEST(Tessellation, PlateAndBox) {
  expect_same_when_refined("plate and box", shapes::box({2, 2, 0.05}), shapes::box({0.5, 0.4, 0.3}), 0.1,
                           0.04, 4);
}

TEST(Tessellation, Gears) {
  expect_same_when_refined("gears", shapes::gear(12), scaled(shapes::gear(12), 0.8), 0.003, 0.0012, 2);
}

TEST(Tessellation, FlushFaces) {
  const TriangleSoup plate = shapes::box({2, 2, 0.2}), box = shapes::box({0.6, 0.4, 0.3});
  const auto fine_plate = make_model(shapes::box({2, 2, 0.2}, {24, 24, 2}));
  const auto fine_box = make_model(shapes::box({0.6, 0.4, 0.3}, {5, 7, 3}));
  const Motion slide = [](double t) {
    return Pose{glm::mat3_cast(glm::angleAxis(0.5 * t, DVec3(0, 0, 1))), {0.9 * t, 0.2 * t, 0.29 + 0.02 * t}};
  };
  EXPECT_LT(
      difference("flush faces", *make_model(plate), *make_model(box), *fine_plate, *fine_box, 0.1, slide),
      kSame);
}

// Where a patch is cut much finer than the way over which it hands over to its border, the force is that of
// the whole patch, too: a tip goes over the border of a plate, and on along it.
TEST(Tessellation, PatchesCutMuchFinerThanTheDistance) {
  const auto tip = make_model(shapes::stylus(0.1, 0.03));
  const auto coarse = make_model(shapes::box({0.05, 0.05, 0.02}));
  const auto fine = make_model(shapes::box({0.05, 0.05, 0.02}, {100, 100, 4}));
  for (const double height : {0.05, 0.09}) {
    const Motion over = [=](double t) {
      return Pose{DMat3(1.0), {0.012 + 0.02 * t, 0.002 * t, 0.01 + height}};
    };
    EXPECT_LT(difference("fine plate", *coarse, *tip, *fine, *tip, 0.1, over), 1e-6);
  }
}

// A ball is another shape when it is cut finer: nearer to round.
TEST(Tessellation, BallOnAPlate) {
  const auto plate = make_model(shapes::box({2, 2, 0.2}));
  const auto coarse = make_model(shapes::icosphere(0.3, 8)), fine = make_model(shapes::icosphere(0.3, 32));
  const Motion roll = [](double t) {
    return Pose{glm::mat3_cast(glm::angleAxis(2.0 * t, glm::normalize(DVec3(1, 2, 0.5)))),
                {0.3 * t, 0.1 * t, 0.1 + 0.3 + 0.05}};
  };
  EXPECT_LT(difference("ball of 1,280 or 20,480", *plate, *coarse, *plate, *fine, 0.1, roll), 0.03);
}

}  // namespace
}  // namespace palpate
