#include "engine/contact/spring.h"

#include <gtest/gtest.h>

namespace palpate {
namespace {

constexpr SpringLaw kLaw{500.0, 0.02};

TEST(Spring, PushesAlongTheDirectionByItsCompression) {
  const SpringContact contact{{1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}, 0.005, 0.25};
  const DVec3 force = spring_force(contact, kLaw);
  EXPECT_DOUBLE_EQ(force.x, 0.0);
  EXPECT_DOUBLE_EQ(force.y, 500.0 * (0.02 - 0.005) * 0.25);
  EXPECT_DOUBLE_EQ(force.z, 0.0);
}

TEST(Spring, IsAtRestFromTheCutoffOnAndNeverPulls) {
  for (const double distance : {0.02, 0.03, 1e6}) {
    EXPECT_EQ(spring_force({{}, {1.0, 0.0, 0.0}, distance, 1.0}, kLaw), DVec3(0.0)) << distance;
  }
}

TEST(Spring, SharesOfAPlateauAddUpToOneSpring) {
  const DVec3 up(0.0, 0.0, 1.0);
  DVec3 sum(0.0);
  for (int i = 0; i < 4; ++i) sum += spring_force({{i, 0.0, 0.0}, up, 0.01, 0.25}, kLaw);
  EXPECT_DOUBLE_EQ(sum.z, spring_force({{}, up, 0.01, 1.0}, kLaw).z);
}

TEST(Wrench, TorqueIsAboutTheReference) {
  const Wrench wrench = wrench_about({1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 5.0, 0.0});
  EXPECT_EQ(wrench.force, DVec3(0.0, 5.0, 0.0));
  EXPECT_EQ(wrench.torque, DVec3(0.0, 0.0, 10.0));
}

TEST(Wrench, ForceThroughTheReferenceHasNoTorque) {
  EXPECT_EQ(wrench_about({1.0, 2.0, 3.0}, {1.0, 2.0, 5.0}, {0.0, 0.0, -7.0}).torque, DVec3(0.0));
}

TEST(Wrench, Adds) {
  Wrench sum{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  sum += {{10.0, 20.0, 30.0}, {40.0, 50.0, 60.0}};
  EXPECT_EQ(sum.force, DVec3(11.0, 22.0, 33.0));
  EXPECT_EQ(sum.torque, DVec3(44.0, 55.0, 66.0));
}

}  // namespace
}  // namespace palpate
