#include "engine/device/simulated/handle_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/device/rotation_vector.h"

namespace palpate {
namespace {

constexpr double kTick = 1e-3;  // s
const Box kWide{DVec3(-10.0), DVec3(10.0)};

void run(HandleBody& body, double seconds, const DeviceWrench& wrench, const HandImpedance& hand = {},
         const RigidMotion& target = {}) {
  const int ticks = static_cast<int>(std::lround(seconds / kTick));
  for (int i = 0; i < ticks; ++i) body.step(wrench, hand, target, kTick);
}

TEST(HandleBody, ReachesTheSpeedOfADampedMass) {
  const double m = 0.075, b = 0.5;
  HandleBody body({.mass = m, .damping = b, .inertia = 1e-4}, kWide);
  const DVec3 force(0.3, -0.2, 0.1);
  for (int i = 1; i <= 5; ++i) {
    run(body, 0.1, {force, DVec3(0.0)});
    const double t = 0.1 * i;
    const double rise = 1.0 - std::exp(-b * t / m);
    const DVec3 velocity = force / b * rise;
    const DVec3 position = force / b * (t - m / b * rise);
    EXPECT_LT(glm::distance(body.motion().linear_velocity, velocity), 1e-4 * glm::length(velocity)) << t;
    EXPECT_LT(glm::distance(body.motion().position, position), 1e-3 * glm::length(position)) << t;
  }
}

TEST(HandleBody, FollowsAStepOfTheHandAsAnOscillatorDoes) {
  const HandImpedance hand = {.mass = 0.05, .damping = 2.0, .stiffness = 200.0};
  const double m = 0.125, b = 2.01, x0 = 0.02;
  HandleBody body({.mass = 0.075, .damping = 0.01, .inertia = 1e-4}, kWide);
  RigidMotion target;
  target.position = {0.0, 0.0, x0};
  const double w = std::sqrt(hand.stiffness / m);
  const double zeta = b / (2.0 * std::sqrt(hand.stiffness * m));
  const double wd = w * std::sqrt(1.0 - zeta * zeta);
  for (int i = 1; i <= 30; ++i) {
    run(body, 0.01, {}, hand, target);
    const double t = 0.01 * i;
    const double decay = std::exp(-zeta * w * t);
    const double expected = x0 * (1.0 - decay * (std::cos(wd * t) + zeta * w / wd * std::sin(wd * t)));
    EXPECT_NEAR(body.motion().position.z, expected, 1e-3 * x0) << t;
  }
}

TEST(HandleBody, TurnsAsAStepOfTheHandsOrientationDemands) {
  const HandImpedance hand = {.inertia = 5e-5, .angular_damping = 6e-3, .angular_stiffness = 0.3};
  const double inertia = 1.5e-4, angle = 0.4;
  HandleBody body({.mass = 0.075, .inertia = 1e-4}, kWide);
  const DVec3 axis = glm::normalize(DVec3(1.0, 2.0, -1.0));
  RigidMotion target;
  target.orientation = rotation_by(angle * axis);
  const double w = std::sqrt(hand.angular_stiffness / inertia);
  const double zeta = hand.angular_damping / (2.0 * std::sqrt(hand.angular_stiffness * inertia));
  const double wd = w * std::sqrt(1.0 - zeta * zeta);
  for (int i = 1; i <= 20; ++i) {
    run(body, 0.005, {}, hand, target);
    const double t = 0.005 * i;
    const double expected =
        angle * (1.0 - std::exp(-zeta * w * t) * (std::cos(wd * t) + zeta * w / wd * std::sin(wd * t)));
    EXPECT_LT(glm::distance(rotation_vector(body.motion().orientation), expected * axis), 2e-3 * angle) << t;
  }
}

// Spring and damper of the hand both follow its target, within a tick as from tick to tick.
TEST(HandleBody, KeepsUpWithAHandThatMovesSteadily) {
  HandleBody body({.mass = 0.075, .inertia = 1e-4}, kWide);
  RigidMotion target;
  target.linear_velocity = {0.1, -0.2, 0.0};
  target.angular_velocity = {0.0, 0.0, 1.0};
  for (int i = 0; i < 1500; ++i) {
    body.step({}, impedance_of(Grip::kLight), target, kTick);
    target.position += kTick * target.linear_velocity;
    target.orientation = rotation_by(kTick * target.angular_velocity) * target.orientation;
  }
  EXPECT_LT(glm::distance(body.motion().position, target.position), 1e-5);
  EXPECT_LT(glm::length(rotation_between(body.motion().orientation, target.orientation)), 5e-5);
}

TEST(HandleBody, SpinsDownByItsDamping) {
  const double inertia = 1e-4, b = 1e-3, w0 = 8.0;
  HandleBody body({.mass = 0.075, .inertia = inertia, .angular_damping = b}, kWide);
  RigidMotion spinning;
  const DVec3 axis = glm::normalize(DVec3(-1.0, 0.5, 2.0));
  spinning.angular_velocity = w0 * axis;
  body.place(spinning);
  run(body, 0.2, {});
  const double decay = std::exp(-b * 0.2 / inertia);
  EXPECT_LT(glm::distance(body.motion().angular_velocity, w0 * decay * axis), 1e-3 * w0);
  const DVec3 turned = w0 * inertia / b * (1.0 - decay) * axis;
  EXPECT_LT(glm::distance(rotation_vector(body.motion().orientation), turned), 1e-3 * glm::length(turned));
}

TEST(HandleBody, SlidesToAHaltByFrictionAlone) {
  const double m = 0.075, friction = 0.04, v0 = 0.2;
  HandleBody body({.mass = m, .friction = friction, .inertia = 1e-4}, kWide);
  RigidMotion sliding;
  sliding.linear_velocity = {0.6 * v0, 0.8 * v0, 0.0};
  body.place(sliding);
  const double halt = v0 * m / friction;
  run(body, 0.9 * halt, {});
  EXPECT_NEAR(glm::length(body.motion().linear_velocity), 0.1 * v0, 0.01 * v0);
  run(body, 0.2 * halt, {});
  EXPECT_EQ(body.motion().linear_velocity, DVec3(0.0));
  EXPECT_NEAR(glm::length(body.motion().position), v0 * halt / 2.0, 1e-4 * v0 * halt);
}

TEST(HandleBody, SticksUntilTheForceExceedsFriction) {
  HandleBody body({.mass = 0.075, .friction = 0.04, .inertia = 1e-4, .angular_friction = 1e-3}, kWide);
  run(body, 0.5, {DVec3(0.0, 0.0399, 0.0), DVec3(0.0, 0.0, 0.99e-3)});
  EXPECT_EQ(body.motion().position, DVec3(0.0));
  EXPECT_EQ(rotation_vector(body.motion().orientation), DVec3(0.0));
  run(body, 0.5, {DVec3(0.0, 0.0401, 0.0), DVec3(0.0, 0.0, 1.01e-3)});
  EXPECT_GT(body.motion().position.y, 0.0);
  EXPECT_GT(rotation_vector(body.motion().orientation).z, 0.0);
}

TEST(HandleBody, CountsTheWorkOfItsActuators) {
  const double m = 0.075, inertia = 1e-4;
  HandleBody body({.mass = m, .inertia = inertia}, kWide);
  run(body, 0.2, {DVec3(0.5, 0.0, 0.0), DVec3(0.0, 2e-3, 0.0)});
  const double v = body.motion().linear_velocity.x, w = body.motion().angular_velocity.y;
  const double kinetic = 0.5 * m * v * v + 0.5 * inertia * w * w;
  EXPECT_NEAR(body.energy().by_actuators, kinetic, 1e-3 * kinetic);
  EXPECT_EQ(body.energy().by_hand, 0.0);
}

// Whatever the device gives, less what it burns itself, the hand gets.
TEST(HandleBody, GivesTheHandWhatTheActuatorsSpend) {
  HandleBody body({.mass = 0.075, .inertia = 1e-4}, kWide);
  const HandImpedance hand = {.damping = 2.0, .stiffness = 200.0};
  run(body, 2.0, {DVec3(2.0, 0.0, 0.0), DVec3(0.0)}, hand);
  EXPECT_NEAR(body.motion().position.x, 0.01, 1e-6);
  EXPECT_NEAR(body.energy().by_actuators, 2.0 * 0.01, 1e-5);
  EXPECT_NEAR(-body.energy().by_hand, 2.0 * 0.01, 1e-4);
}

TEST(HandleBody, IsStoppedAtTheBorderOfItsWorkspace) {
  HandleBody body({.mass = 0.075, .damping = 0.01, .inertia = 1e-4}, {DVec3(-0.05), DVec3(0.05)});
  run(body, 2.0, {DVec3(8.5, 0.0, -8.5), DVec3(0.0)});
  EXPECT_NEAR(body.motion().position.x, 0.05 + 8.5e-4, 1e-5);
  EXPECT_NEAR(body.motion().position.z, -0.05 - 8.5e-4, 1e-5);
  EXPECT_EQ(body.motion().position.y, 0.0);
}

TEST(HandleBody, DoesNotDependOnHowItsTimeIsCut) {
  const HandleProperties properties = {.mass = 0.075, .damping = 0.01, .friction = 0.04, .inertia = 1e-4};
  const HandImpedance hand = impedance_of(Grip::kLight);
  RigidMotion target;
  target.position = {0.01, 0.0, 0.0};
  HandleBody fine(properties, kWide), coarse(properties, kWide);
  for (int i = 0; i < 100; ++i) fine.step({}, hand, target, 1e-3);
  for (int i = 0; i < 10; ++i) coarse.step({}, hand, target, 1e-2);
  EXPECT_LT(glm::distance(fine.motion().position, coarse.motion().position), 1e-9);
}

}  // namespace
}  // namespace palpate
