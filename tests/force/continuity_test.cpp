// The smooth law's force is continuous in the pose: steps of the force shrink with steps of the motion.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "assets/shapes/box.h"
#include "assets/shapes/gear.h"
#include "assets/shapes/organic.h"
#include "tests/force/shapes.h"
#include "tests/force/wrench_along.h"
#include "tests/support/models.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 20;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kTrials = 1;
#else
constexpr int kTrials = 4;
#endif

// The largest steps of a wrench at step h, h/4 and h/16 of a motion.
struct Steps {
  double coarse = 0.0;
  double middle = 0.0;
  double fine = 0.0;

  void add(const std::vector<Wrench>& wrenches) {
    coarse = std::max(coarse, largest_step(wrenches, 16));
    middle = std::max(middle, largest_step(wrenches, 4));
    fine = std::max(fine, largest_step(wrenches, 1));
  }
};

// Of one pair of models over some motions, under both laws.
class Continuity {
 public:
  Continuity(const char* name, double cutoff, int steps) : name_(name), cutoff_(cutoff), steps_(steps) {}

  void move(const Model& a, const Model& b, const Motion& motion) {
    springs_.add(wrenches_along(a, b, motion, 16 * steps_, cutoff_, ForceLaw::kSprings));
    smooth_.add(wrenches_along(a, b, motion, 16 * steps_, cutoff_, ForceLaw::kSmooth));
  }

  void expect_smooth() const {
    std::printf("%-28s largest step at h, h/4, h/16: springs %.4f %.4f %.4f, smooth %.4f %.4f %.4f\n", name_,
                springs_.coarse, springs_.middle, springs_.fine, smooth_.coarse, smooth_.middle,
                smooth_.fine);
    EXPECT_GT(smooth_.coarse, 0.0);
    EXPECT_TRUE(shrinks(smooth_.coarse, smooth_.middle)) << name_;
    EXPECT_TRUE(shrinks(smooth_.middle, smooth_.fine)) << name_;
  }

 private:
  static bool shrinks(double before, double after) { return after < 1e-3 || 3 * after <= before; }

  const char* name_;
  double cutoff_;
  int steps_;
  Steps springs_;
  Steps smooth_;
};

TEST(Continuity, GearPair) {
  const auto a = make_model(shapes::gear(18)), b = make_model(scaled(shapes::gear(12), 0.8));
  Continuity continuity("gear pair", 0.003, 100);
  Random random(kSeed);
  for (int i = 0; i < kTrials; ++i) continuity.move(*a, *b, drift(*a, *b, 0.003, 0.0012, random));
  continuity.expect_smooth();
}

TEST(Continuity, BumpyPair) {
  const auto a = make_model(shapes::organic({40, 36, 28}));
  const auto b = make_model(scaled(shapes::organic(shapes::kOrganicCoarse), 0.5));
  Continuity continuity("bumpy pair", 0.005, 100);
  Random random(kSeed);
  for (int i = 0; i < kTrials; ++i) continuity.move(*a, *b, drift(*a, *b, 0.005, 0.002, random));
  continuity.expect_smooth();
}

// The lowest corner stays at one height.
Pose rocking(double t, const DVec3& half, double top, double gap) {
  const double about_x = 0.03 * std::sin(6.283185307 * t) + 0.0007;
  const double about_y = 0.02 * std::sin(12.56637061 * t + 1.0);
  const DMat3 rotation = glm::mat3_cast(glm::angleAxis(about_x, DVec3(1, 0, 0))) *
                         glm::mat3_cast(glm::angleAxis(about_y, DVec3(0, 1, 0)));
  double low = 0.0;
  for (int k = 0; k < 3; ++k) low -= std::abs(rotation[k][2]) * half[k];
  return {rotation, {0.013, 0.021, top + gap - low}};
}

void rock(const char* name, int divisions) {
  const auto plate = make_model(shapes::box({2, 2, 0.2}, {divisions, divisions, 1}));
  const auto box = make_model(shapes::box({0.6, 0.4, 0.3}, {divisions, divisions, divisions}));
  Continuity continuity(name, 0.1, 150);
  continuity.move(*plate, *box, [](double t) { return rocking(t, {0.3, 0.2, 0.15}, 0.1, 0.03); });
  continuity.expect_smooth();
}

TEST(Continuity, RockingBox) {
  rock("box rocking on a plate", 1);
}

TEST(Continuity, RockingFineBox) {
  rock("8 x 8 box rocking on 8 x 8", 8);
}

// It hangs over the plate's rim.
TEST(Continuity, RockingBoxOverARim) {
  const auto plate = make_model(shapes::box({0.5, 0.5, 0.2})), box = make_model(shapes::box({0.6, 0.4, 0.3}));
  Continuity continuity("box rocking over a rim", 0.1, 150);
  continuity.move(*plate, *box, [](double t) { return rocking(t, {0.3, 0.2, 0.15}, 0.1, 0.03); });
  continuity.expect_smooth();
}

TEST(Continuity, VertexInABowl) {
  const auto bowl = make_model(shapes::bowl(0.5, 0.3, 40)), stylus = make_model(shapes::stylus(0.2, 0.05));
  Continuity continuity("vertex in a fine bowl", 0.05, 400);
  continuity.move(*bowl, *stylus, [](double t) {
    const double x = 0.11 * (t - 0.45), y = 0.03 * t;
    return Pose{DMat3(1.0), {x, y, (x * x + y * y) + 0.02}};
  });
  continuity.expect_smooth();
}

// From one side of parallel to the other, past exactly parallel or past it at a small offset and tilt.
TEST(Continuity, NearParallelEdges) {
  const auto lower = make_model(shapes::ridge(1.0, 0.2, 0.2)),
             upper = make_model(shapes::ridge(0.8, 0.2, 0.2));
  const DMat3 upside_down = glm::mat3_cast(glm::angleAxis(3.14159265358979, DVec3(1, 0, 0)));
  for (const bool exact : {false, true}) {
    Continuity continuity(exact ? "edges crossing, parallel" : "edges crossing", 0.05, 200);
    continuity.move(*lower, *upper, [&](double t) {
      const double yaw = 0.3 * (t - (exact ? 0.5 : 0.4821)), pitch = exact ? 0.0 : 0.003 * std::sin(9 * t);
      const DMat3 turn = glm::mat3_cast(glm::angleAxis(yaw, DVec3(0, 0, 1))) *
                         glm::mat3_cast(glm::angleAxis(pitch, DVec3(0, 1, 0)));
      return Pose{turn * upside_down, {0.01, exact ? 0.002 : 0.002 + 0.01 * t, 0.02}};
    });
    continuity.expect_smooth();
  }
}

}  // namespace
}  // namespace palpate
