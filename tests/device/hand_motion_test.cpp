#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/device/rotation_vector.h"
#include "engine/device/simulated/recorded_motion.h"
#include "engine/device/simulated/scripted_motion.h"

namespace palpate {
namespace {

constexpr double kNear = 1e-12;
constexpr HandScript kScripts[] = {HandScript::kHold,  HandScript::kTap,   HandScript::kPress,
                                   HandScript::kSlide, HandScript::kWedge, HandScript::kCircle};

ScriptParameters example() {
  ScriptParameters parameters;
  parameters.origin.position = {0.01, 0.02, 0.03};
  parameters.depth = 0.012;
  parameters.travel = 0.02;
  parameters.period = 0.5;
  return parameters;
}

DVec3 offset_at(HandScript script, double time) {
  return ScriptedMotion(script, example()).at(time).position - example().origin.position;
}

TEST(ScriptedMotion, StartsAtItsOriginAndMovesWithoutJumps) {
  ScriptParameters parameters = example();
  parameters.twist = 0.3;
  for (const HandScript script : kScripts) {
    const ScriptedMotion motion(script, parameters);
    EXPECT_EQ(motion.at(0.0).position, parameters.origin.position);
    HandPose before = motion.at(0.0);
    for (int i = 1; i <= 4000; ++i) {
      const HandPose now = motion.at(i * 1e-3);
      ASSERT_LT(glm::distance(now.position, before.position), 0.5e-3) << static_cast<int>(script) << " " << i;
      ASSERT_LT(glm::length(rotation_between(before.orientation, now.orientation)), 6e-3);
      before = now;
    }
  }
}

TEST(ScriptedMotion, TapsInAndOut) {
  EXPECT_NEAR(offset_at(HandScript::kTap, 0.25).y, -0.012, kNear);
  EXPECT_NEAR(offset_at(HandScript::kTap, 0.5).y, 0.0, kNear);
  EXPECT_NEAR(offset_at(HandScript::kTap, 7.75).y, -0.012, kNear);
}

TEST(ScriptedMotion, PressesAndStays) {
  EXPECT_NEAR(offset_at(HandScript::kPress, 0.25).y, -0.006, kNear);
  EXPECT_NEAR(offset_at(HandScript::kPress, 0.5).y, -0.012, kNear);
  EXPECT_NEAR(offset_at(HandScript::kPress, 9.0).y, -0.012, kNear);
}

TEST(ScriptedMotion, SlidesOnlyAfterItHasPressed) {
  EXPECT_EQ(offset_at(HandScript::kSlide, 0.4).x, 0.0);
  EXPECT_NEAR(offset_at(HandScript::kSlide, 0.75).x, 0.02, kNear);
  EXPECT_NEAR(offset_at(HandScript::kSlide, 1.0).x, 0.0, kNear);
  EXPECT_NEAR(offset_at(HandScript::kSlide, 0.75).y, -0.012, kNear);
}

TEST(ScriptedMotion, WedgesDeepWhileItSwaysToBothSides) {
  EXPECT_NEAR(offset_at(HandScript::kWedge, 1.125).x, 0.02, kNear);
  EXPECT_NEAR(offset_at(HandScript::kWedge, 1.375).x, -0.02, kNear);
  EXPECT_NEAR(offset_at(HandScript::kWedge, 1.375).y, -0.012, kNear);
}

TEST(ScriptedMotion, CirclesAtItsRadius) {
  for (int i = 0; i < 50; ++i) {
    EXPECT_NEAR(glm::length(offset_at(HandScript::kCircle, 0.5 + 0.013 * i)), 0.02, kNear);
  }
  EXPECT_NEAR(offset_at(HandScript::kCircle, 1.125).y, -0.02, kNear);
}

TEST(ScriptedMotion, TwistsAboutTheDirectionItPresses) {
  ScriptParameters parameters = example();
  parameters.twist = 0.3;
  const HandPose pose = ScriptedMotion(HandScript::kPress, parameters).at(1.125);
  EXPECT_LT(glm::distance(rotation_vector(pose.orientation), DVec3(0.0, -0.3, 0.0)), 1e-9);
}

TEST(RecordedMotion, GoesStraightBetweenPosesAndHoldsAtItsEnds) {
  const HandPose first{DVec3(0.0), DQuat(1.0, 0.0, 0.0, 0.0)};
  const HandPose second{DVec3(0.02, 0.0, 0.0), 3.0 * rotation_by(DVec3(0.0, 0.8, 0.0))};
  const auto made = RecordedMotion::from({{5.0, first}, {5.5, second}});
  ASSERT_TRUE(made);
  const HandMotion& motion = *made.value();
  EXPECT_NEAR(motion.at(0.125).position.x, 0.005, kNear);
  EXPECT_NEAR(rotation_vector(motion.at(0.125).orientation).y, 0.2, 1e-9);
  EXPECT_EQ(motion.at(0.0).position, first.position);
  EXPECT_EQ(motion.at(99.0).position, second.position);
  EXPECT_NEAR(glm::length(motion.at(99.0).orientation), 1.0, kNear);
}

TEST(RecordedMotion, RefusesWhatIsNoRecording) {
  const HandPose good;
  HandPose no_rotation;
  no_rotation.orientation = DQuat(0.0, 0.0, 0.0, 0.0);
  HandPose not_a_number;
  not_a_number.position.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(RecordedMotion::from({}));
  for (const auto& second : {RecordedPose{0.0, good}, RecordedPose{-1.0, good},
                             RecordedPose{1.0, no_rotation}, RecordedPose{1.0, not_a_number}}) {
    const auto made = RecordedMotion::from({{0.0, good}, second});
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message.find("pose 1"), std::string::npos) << made.error().message;
  }
}

}  // namespace
}  // namespace palpate
