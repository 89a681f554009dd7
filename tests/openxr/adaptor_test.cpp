// The functions of openxr_adaptor.h alone, and a controller whose tool meets a plate of the library.
#include "palpate/openxr_adaptor.h"

#include <cmath>
#include <limits>
#include <random>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr unsigned kSeed = 11;

plp_pose pose_at(double x, double y, double z) {
  return {{x, y, z}, {0, 0, 0, 1}};
}

plp_pose turned(double x, double y, double z, double about_y) {
  return {{x, y, z}, {0, std::sin(about_y / 2), 0, std::cos(about_y / 2)}};
}

plp_pose random_pose(std::mt19937& random) {
  std::normal_distribution<double> normal;
  plp_pose pose{};
  double squared = 0;
  for (double& number : pose.position) number = normal(random);
  for (double& number : pose.orientation) {
    number = normal(random);
    squared += number * number;
  }
  for (double& number : pose.orientation) number /= std::sqrt(squared);
  return pose;
}

// 1 if both turn alike.
double alignment(const plp_pose& a, const plp_pose& b) {
  double dot = 0;
  for (int i = 0; i < 4; ++i) dot += a.orientation[i] * b.orientation[i];
  return std::abs(dot);
}

double distance(const plp_pose& a, const plp_pose& b) {
  return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1],
                    a.position[2] - b.position[2]);
}

plp_contacts contact_of(double force) {
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  contacts.set_count = 1;
  contacts.wrench.force[2] = force;
  return contacts;
}

TEST(OpenXrPose, OneThatIsNoneIsRefused) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  const plp_openxr_pose none[] = {{{0, 0, 0, 0}, {0, 0, 0}},
                                  {{0, nan, 0, 1}, {0, 0, 0}},
                                  {{infinite, 0, 0, 1}, {0, 0, 0}},
                                  {{0, 0, 0, 1}, {0, nan, 0}},
                                  {{0, 0, 0, 1}, {0, 0, infinite}}};
  for (const plp_openxr_pose& located : none) {
    plp_pose pose = pose_at(1, 2, 3);
    EXPECT_EQ(plp_openxr_pose_in(&located, &pose), 0);
    EXPECT_EQ(pose.position[2], 3) << "untouched";
  }
}

TEST(OpenXrPose, ComesBackNormalised) {
  const plp_openxr_pose located = {{0, 2, 0, 0}, {1, -2, 3}};
  plp_pose pose;
  ASSERT_EQ(plp_openxr_pose_in(&located, &pose), 1);
  const plp_openxr_pose drawn = plp_openxr_pose_out(&pose);
  EXPECT_EQ(drawn.orientation[1], 1.0F);
  EXPECT_EQ(drawn.position[1], -2.0F);
}

TEST(OpenXrPose, BetweenTwoItTurnsEvenlyTheShorterWay) {
  std::mt19937 random(kSeed);
  SCOPED_TRACE(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const plp_pose from = random_pose(random), to = random_pose(random);
    EXPECT_NEAR(alignment(plp_openxr_between(&from, &to, 0), from), 1, 1e-12);
    EXPECT_NEAR(alignment(plp_openxr_between(&from, &to, 1), to), 1, 1e-12);
    const plp_pose half = plp_openxr_between(&from, &to, 0.5);
    EXPECT_NEAR(alignment(from, half), alignment(half, to), 1e-12);
    EXPECT_GE(alignment(from, half), std::sqrt(0.5) - 1e-12) << "at most a quarter turn of the half";
    EXPECT_NEAR(distance(from, half), distance(half, to), 1e-12);
  }
}

TEST(OpenXrFollow, AFreeToolComesToTheHand) {
  const plp_openxr_grip grip = plp_openxr_grip_light();
  const plp_wrench none{};
  const plp_pose hand = turned(0.1, -0.2, 0.3, 2.0);
  plp_pose tool = pose_at(0, 0, 0);
  double before = distance(hand, tool);
  for (int i = 0; i < 500; ++i) {
    tool = plp_openxr_follow(&grip, &hand, &tool, &none, 1e-3);
    ASSERT_LE(distance(hand, tool), before) << "never past it";
    before = distance(hand, tool);
  }
  EXPECT_LT(before, 1e-9);
  EXPECT_NEAR(alignment(hand, tool), 1, 1e-9);
}

TEST(OpenXrFollow, RestsWhereTheHandHoldsTheWrench) {
  const plp_openxr_grip grip = plp_openxr_grip_light();
  const plp_wrench wrench = {{0, 2, 0}, {0, 0.1, 0}};
  const plp_pose hand = pose_at(0, 0, 0);
  plp_pose tool = hand;
  for (int i = 0; i < 2000; ++i) tool = plp_openxr_follow(&grip, &hand, &tool, &wrench, 1e-3);
  EXPECT_NEAR(tool.position[1], 2 / grip.stiffness, 1e-9);
  EXPECT_NEAR(2 * std::atan2(tool.orientation[1], tool.orientation[3]), 0.1 / grip.angular_stiffness, 1e-9);
}

TEST(OpenXrFollow, NoGripAndNoFrameIsTooStiff) {
  const plp_openxr_grip grip = {1e9, 1e-3, 1e9, 1e-3};
  const plp_wrench none{};
  const plp_pose hand = turned(1, 0, 0, 1.0);
  plp_pose tool = pose_at(0, 0, 0);
  tool = plp_openxr_follow(&grip, &hand, &tool, &none, 1.0);
  EXPECT_NEAR(distance(hand, tool), 0, 1e-9);
  EXPECT_NEAR(alignment(hand, tool), 1, 1e-9);
}

TEST(OpenXrFollow, AWrenchThatIsNoneDoesNotSpread) {
  const plp_openxr_grip grip = plp_openxr_grip_light();
  const plp_wrench wrench = {{0, kNaN, 0}, {0, 0, std::numeric_limits<double>::infinity()}};
  const plp_pose hand = pose_at(1, 0, 0);
  plp_pose tool = pose_at(0, 0, 0);
  tool = plp_openxr_follow(&grip, &hand, &tool, &wrench, 1e-3);
  EXPECT_GT(tool.position[0], 0);
  EXPECT_EQ(tool.position[1], 0);
}

TEST(OpenXrVibration, TicksAtTheBeginAndFollowsTheForce) {
  const plp_openxr_vibration_options options = plp_openxr_vibration_defaults();
  plp_openxr_touch touch{};
  plp_contacts none;
  plp_contacts_init(&none, sizeof none);
  EXPECT_EQ(plp_openxr_vibrate(&options, &touch, &none, 0.0).amplitude, 0);
  plp_contacts contacts = contact_of(1.0);
  const plp_openxr_vibration tick = plp_openxr_vibrate(&options, &touch, &contacts, 1.0);
  EXPECT_FLOAT_EQ(tick.amplitude, 0.8F);
  EXPECT_EQ(tick.duration, 12'000'000);
  EXPECT_EQ(plp_openxr_vibrate(&options, &touch, &contacts, 1.004).duration, 8'000'000) << "what is left";
  const plp_openxr_vibration held = plp_openxr_vibrate(&options, &touch, &contacts, 1.012);
  EXPECT_FLOAT_EQ(held.amplitude, 0.2F);
  EXPECT_EQ(held.duration, 50'000'000);
  contacts = contact_of(100.0);
  EXPECT_EQ(plp_openxr_vibrate(&options, &touch, &contacts, 1.1).amplitude, 1.0F);
  EXPECT_EQ(plp_openxr_vibrate(&options, &touch, &none, 1.2).amplitude, 0);
  EXPECT_EQ(plp_openxr_vibrate(&options, &touch, &none, 1.2).duration, 0);
}

TEST(OpenXrVibration, AStrongContactIsNotWeakenedByItsTick) {
  const plp_openxr_vibration_options options = plp_openxr_vibration_defaults();
  plp_openxr_touch touch{};
  const plp_contacts contacts = contact_of(100.0);
  EXPECT_EQ(plp_openxr_vibrate(&options, &touch, &contacts, 0.0).amplitude, 1.0F);
}

TEST(OpenXrVibration, EndsWhenTheControllerIsLostAndTicksAnew) {
  const plp_openxr_vibration_options options = plp_openxr_vibration_defaults();
  plp_openxr_touch touch{};
  const plp_contacts contacts = contact_of(0.5);
  plp_openxr_vibrate(&options, &touch, &contacts, 0.0);
  EXPECT_EQ(plp_openxr_vibrate(&options, &touch, nullptr, 0.001).amplitude, 0);
  EXPECT_FLOAT_EQ(plp_openxr_vibrate(&options, &touch, &contacts, 5.0).amplitude, 0.8F);
}

TEST(OpenXrVibration, ANumberThatIsNoneIsSilent) {
  const plp_openxr_vibration_options options = plp_openxr_vibration_defaults();
  plp_wrench wrench{};
  wrench.torque[0] = kNaN;
  EXPECT_EQ(plp_openxr_amplitude(&options, &wrench), 0);
  wrench = {{std::numeric_limits<double>::infinity(), 0, 0}, {0, 0, 0}};
  EXPECT_EQ(plp_openxr_amplitude(&options, &wrench), 0);
  wrench = {{0, 0, 0}, {0.1, 0, 0}};
  EXPECT_DOUBLE_EQ(plp_openxr_amplitude(&options, &wrench), 0.5);
}

TEST(OpenXrCurl, AFingerIsHeldWhereItIsPushed) {
  EXPECT_EQ(plp_openxr_curl(0.3, 0, 5), 0) << "free";
  EXPECT_EQ(plp_openxr_curl(0.3, -1, 5), 0) << "pulled along";
  EXPECT_FLOAT_EQ(plp_openxr_curl(0.0, 5, 5), 1.0F) << "cannot curl at all";
  EXPECT_FLOAT_EQ(plp_openxr_curl(0.25, 50, 5), 0.75F) << "no further than now";
  EXPECT_FLOAT_EQ(plp_openxr_curl(0.25, 2.5, 5), 0.375F);
  EXPECT_EQ(plp_openxr_curl(1.5, 5, 5), 0);
  EXPECT_EQ(plp_openxr_curl(kNaN, 5, 5), 0);
  EXPECT_EQ(plp_openxr_curl(0.5, kNaN, 5), 0);
}

// A host with 90 frames a second whose hand sinks into a plate by 20 mm.
TEST(OpenXrHost, TheDrawnToolStaysOutsideOfWhatTheHandGoesInto) {
  constexpr int kStepsAFrame = 11;
  constexpr double kFrame = 1.0 / 90.0, kCutoff = 0.01;
  TestScene scene(TestScene::options_with(kCutoff));
  const TestModel plate(box(0.2F, 0.02F, 0.2F)), brick(box(0.02F, 0.02F, 0.02F));
  scene.add(plate.handle, PLP_BODY_STATIC, pose_at(0, 0, 0));
  const plp_body body = scene.add(brick.handle, PLP_BODY_TOOL, pose_at(0, 0.1, 0));
  const plp_openxr_grip grip = {200, 40, 0.5, 0.05};
  const plp_openxr_vibration_options options = plp_openxr_vibration_defaults();
  plp_openxr_touch touch{};
  plp_pose hand = pose_at(0, 0.1, 0), tool = hand;
  plp_contacts contacts = scene.step();
  int ticks = 0;
  for (int frame = 0; frame < 270; ++frame) {
    const float height = std::max(0.02F, 0.1F - 0.001F * static_cast<float>(frame));
    const plp_openxr_pose located = {{0, 0, 0, 1}, {0, height, 0}};
    const plp_pose last = hand;
    ASSERT_EQ(plp_openxr_pose_in(&located, &hand), 1);
    for (int i = 1; i <= kStepsAFrame; ++i) {
      const plp_pose goal = plp_openxr_between(&last, &hand, static_cast<double>(i) / kStepsAFrame);
      tool = plp_openxr_follow(&grip, &goal, &tool, &contacts.wrench, kFrame / kStepsAFrame);
      ASSERT_EQ(plp_scene_set_pose(scene.handle, body, &tool), PLP_OK);
      contacts = scene.step();
      ASSERT_EQ(contacts.overlap, 0) << "frame " << frame;
    }
    const bool was_touching = touch.touching != 0;
    const plp_openxr_vibration felt = plp_openxr_vibrate(&options, &touch, &contacts, frame * kFrame);
    ASSERT_EQ(felt.amplitude > 0, contacts.set_count > 0);
    ticks += !was_touching && felt.amplitude > 0;
  }
  EXPECT_EQ(ticks, 1);
  EXPECT_GT(plp_openxr_pose_out(&tool).position[1], 0.04F) << "on the plate";
  EXPECT_NEAR(contacts.wrench.force[1], grip.stiffness * (tool.position[1] - hand.position[1]), 1e-3);
}

}  // namespace
}  // namespace palpate::test
