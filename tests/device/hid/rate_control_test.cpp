#include "engine/device/hid/rate_control.h"

#include <gtest/gtest.h>

#include "engine/device/rotation_vector.h"

namespace palpate {
namespace {

constexpr RateGains kGains{0.2, 2.0, 0.1};
const Box kReach{DVec3(-0.3), DVec3(0.3)};

RateControl pushed(const std::array<double, 6>& deflection, int steps, double dt) {
  RateControl control(kGains, kReach);
  control.push(deflection);
  for (int i = 0; i < steps; ++i) control.step(dt);
  return control;
}

TEST(RateControl, FullDeflectionMovesAtFullSpeed) {
  const RateControl control = pushed({1.0, -1.0, 0.0, 0.0, 0.0, 1.0}, 1000, 1e-3);
  EXPECT_NEAR(control.motion().position.x, 0.2, 1e-9);
  EXPECT_NEAR(control.motion().position.y, -0.2, 1e-9);
  EXPECT_NEAR(rotation_vector(control.motion().orientation).z, 2.0, 1e-9);
  EXPECT_NEAR(control.motion().linear_velocity.x, 0.2, 1e-9);
  EXPECT_NEAR(control.motion().angular_velocity.z, 2.0, 1e-12);
}

TEST(RateControl, TheDeadZoneHoldsStillAndSpeedBeginsAtItsBorder) {
  EXPECT_EQ(pushed({0.1, -0.1, 0.05, 0.1, 0.0, 0.0}, 10, 1e-3).motion().position, DVec3(0.0));
  EXPECT_EQ(pushed({0.1, -0.1, 0.05, 0.1, 0.0, 0.0}, 10, 1e-3).motion().angular_velocity, DVec3(0.0));
  EXPECT_NEAR(pushed({0.1009, 0, 0, 0, 0, 0}, 1, 1e-3).motion().linear_velocity.x, 0.2 * 1e-3, 1e-9);
  EXPECT_NEAR(pushed({0.55, 0, 0, 0, 0, 0}, 1, 1e-3).motion().linear_velocity.x, 0.1, 1e-9);
}

TEST(RateControl, ThePathDoesNotDependOnTheStep) {
  const std::array<double, 6> deflection{0.4, 0.3, -0.9, 0.7, -0.2, 0.5};
  const RigidMotion coarse = pushed(deflection, 100, 10e-3).motion();
  const RigidMotion fine = pushed(deflection, 4000, 0.25e-3).motion();
  EXPECT_LT(glm::distance(coarse.position, fine.position), 1e-9);
  EXPECT_LT(glm::length(rotation_between(coarse.orientation, fine.orientation)), 1e-9);
}

TEST(RateControl, ItStaysInItsReachAndComesBackAtOnce) {
  RateControl control = pushed({1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 5000, 1e-3);
  EXPECT_EQ(control.motion().position.x, 0.3);
  EXPECT_EQ(control.motion().linear_velocity.x, 0.0);
  control.push({-1.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  control.step(1e-3);
  EXPECT_NEAR(control.motion().position.x, 0.2998, 1e-9);
}

TEST(RateControl, NoTimeMovesNothing) {
  EXPECT_EQ(pushed({1.0, 0, 0, 0, 0, 0}, 10, 0.0).motion().position, DVec3(0.0));
  EXPECT_EQ(pushed({1.0, 0, 0, 0, 0, 0}, 10, -1.0).motion().position, DVec3(0.0));
}

}  // namespace
}  // namespace palpate
