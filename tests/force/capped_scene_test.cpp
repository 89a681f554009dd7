// What a hand feels of a scene under a stiffness cap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "engine/scene/scene.h"
#include "tests/support/models.h"

namespace palpate {
namespace {

constexpr double kCutoff = 0.01;  // m
constexpr double kStep = 2e-5;    // m
constexpr double kBox = 0.1;      // m, of an edge

Pose at(const DVec3& place) {
  return {DMat3(1.0), place};
}

// A box as the tool, which moves along y, among such boxes.
class Boxes {
 public:
  Boxes(ForceLaw law, double stiffness, double cap, const std::vector<DVec3>& places)
      : scene_({.cutoff = kCutoff, .stiffness = stiffness, .stiffness_cap = cap, .law = law}) {
    const auto box = asset_model("box");
    for (const DVec3& place : places) scene_.add({.model = box, .pose = at(place)});
    tool_ = scene_.add({.kind = BodyKind::kTool, .model = box, .pose = {}}).value();
  }

  double force_at(double height) {
    scene_.set_pose(tool_, at({0.0, height, 0.0}));
    scene_.step();
    return scene_.contacts().wrench.force.y;
  }
  const Contacts& contacts() const { return scene_.contacts(); }

 private:
  Scene scene_;
  BodyId tool_ = 0;
};

// The tool goes down: the force upward never falls, and never rises by more than the cap times the way.
// Returns the stiffest step, N/m.
double lower(Boxes& boxes, double from, double to, double cap) {
  double before = boxes.force_at(from), stiffest = 0.0;
  for (double height = from - kStep; height > to; height -= kStep) {
    const double force = boxes.force_at(height), stiffness = (force - before) / kStep;
    EXPECT_GE(stiffness, -1e-6 * cap) << "at " << height;
    EXPECT_LE(stiffness, cap * (1.0 + 1e-6)) << "at " << height;
    if (testing::Test::HasFailure()) break;
    stiffest = std::max(stiffest, stiffness);
    before = force;
  }
  return stiffest;
}

// Down on floors that lie in one place, through their surface and on against the walls.
TEST(CappedScene, IsNoStifferThanItsCapOnAnyNumberOfFloors) {
  for (const ForceLaw law : {ForceLaw::kSprings, ForceLaw::kSmooth}) {
    for (const std::size_t floors : {1, 3}) {
      for (const double cap : {200.0, 800.0, 20000.0}) {
        Boxes boxes(law, 1000.0, cap, std::vector<DVec3>(floors, {0.02, -kBox, 0.03}));
        const double stiffest = lower(boxes, 1.2 * kCutoff, -0.5 * kCutoff, cap);
        EXPECT_TRUE(boxes.contacts().walled());
        std::printf("%s law, %zu floors, cap %.0f: %.1f N/m, %.3f N\n",
                    law == ForceLaw::kSmooth ? "smooth" : "springs", floors, cap, stiffest,
                    boxes.contacts().wrench.force.y);
        EXPECT_LE(stiffest, 0.5 * cap * (1.0 + 1e-6)) << "a face by itself";
      }
    }
  }
}

// Between a floor and a ceiling that are both within the cutoff.
TEST(CappedScene, IsNoStifferThanItsCapBetweenFloorAndCeiling) {
  constexpr double kCap = 800.0, kGap = 0.6 * kCutoff;
  for (const ForceLaw law : {ForceLaw::kSprings, ForceLaw::kSmooth}) {
    Boxes boxes(law, 1e5, kCap, {{0.02, -kBox - kGap, 0.03}, {0.02, kBox + kGap, 0.03}});
    const double stiffest = lower(boxes, 0.9 * kGap, -0.9 * kGap, kCap);
    std::printf("%.1f N/m\n", stiffest);
    EXPECT_GE(stiffest, 0.95 * kCap) << "as stiff as it may be";
  }
}

// An opposite face comes within reach while the first one already pushes.
TEST(CappedScene, DoesNotJumpWhereACeilingComesIntoReach) {
  constexpr double kCap = 800.0;
  Boxes boxes(ForceLaw::kSprings, 1e5, kCap,
              {{0.02, -kBox - 0.2 * kCutoff, 0.03}, {0.02, kBox + 0.9 * kCutoff, 0.03}});
  lower(boxes, 0.5 * kCutoff, -0.15 * kCutoff, kCap);
  EXPECT_EQ(boxes.contacts().set_count, 1u) << "the ceiling is out of reach below";
  boxes.force_at(0.5 * kCutoff);
  EXPECT_EQ(boxes.contacts().set_count, 2u);
}

}  // namespace
}  // namespace palpate
