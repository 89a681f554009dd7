// What fading does to the hand while minima are followed by descent, which loses some and learns of others
// late.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "tests/force/pressed_scene.h"
#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 4;

constexpr int kTicks = 400;

// The largest step of the force over a motion, relative to stiffness × cutoff.
double largest_step(const std::shared_ptr<const Model>& body, const std::shared_ptr<const Model>& tool,
                    const std::vector<Pose>& motion, SceneOptions options) {
  PressedScene scene(body, tool, motion.front(), options);
  DVec3 before = scene.step_to(motion.front()).wrench.force;
  double largest = 0.0;
  for (const Pose& pose : motion) {
    const DVec3 force = scene.step_to(pose).wrench.force;
    largest = std::max(largest, glm::length(force - before));
    before = force;
  }
  return largest / (options.stiffness * options.cutoff);
}

TEST(DescentFade, TakesTheJumpsOutOfComingAndGoing) {
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  const auto body = asset_model("crankshaft_45k"), tool = asset_model("gear_6k", 0.5);
  SceneOptions options = PressedScene::options_with(SearchMode::kDescent);
  const double diagonal = body->bounds().diagonal();
  options.cutoff = 0.02 * diagonal;
  Random random(kSeed);
  const std::vector<Pose> motion =
      sliding_motion(*body, *tool, options.cutoff, 0.3 * diagonal, kTicks, random);
  const double faded = largest_step(body, tool, motion, options);
  options.fade_time = 0.0;
  const double cut = largest_step(body, tool, motion, options);
  std::printf("largest step of the force, of stiffness x cutoff: %.3f cut, %.3f faded\n", cut, faded);
  EXPECT_LT(faded, 0.5 * cut);
}

}  // namespace
}  // namespace palpate
