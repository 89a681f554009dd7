#include "engine/runtime/torque_lever.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "engine/device/rotation_vector.h"
#include "tests/support/random_poses.h"

namespace palpate::test {
namespace {

constexpr double kTiny = 1e-12;

DeviceInfo device_with(DegreesOfFreedom actuated, double max_force) {
  DeviceInfo info;
  info.capabilities.actuated = actuated;
  info.limits.max_force = max_force;
  return info;
}

DeviceWrench random_wrench(Random& random) {
  return {random.uniform(0.0, 5.0) * random.direction(), random.uniform(0.0, 0.2) * random.direction()};
}

// Force and what is left of the torque are, about the pivot, the wrench that was asked for.
TEST(TorqueLever, KeepsTheTorqueAboutItsPivot) {
  constexpr std::uint64_t kSeed = 23;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  Random random(kSeed);
  for (int round = 0; round < 500; ++round) {
    const DVec3 lever = random.uniform(1e-3, 1.0) * random.direction();
    const DQuat turned = rotation_by(random.uniform(0.0, 3.0) * random.direction());
    const DeviceWrench wrench = random_wrench(random);
    const DeviceWrench felt = TorqueLever(lever, device_with(kTranslations, 1e6)).felt(wrench, turned);
    const DVec3 arm = turned * lever, added = felt.force - wrench.force;
    const double size = 1.0 + glm::length(added);
    EXPECT_NEAR(glm::dot(added, arm), 0.0, kTiny * size);
    EXPECT_LT(glm::distance(felt.torque + glm::cross(arm, added), wrench.torque), kTiny * size);
    EXPECT_LT(glm::length(glm::cross(felt.torque, arm)), kTiny * size) << "only what lies along it is left";
  }
}

TEST(TorqueLever, AddsAtMostHalfOfWhatTheDeviceCan) {
  const DeviceWrench wrench{{0.0, 1.0, 0.0}, {0.0, 0.0, 0.2}};
  const TorqueLever lever({0.01, 0.0, 0.0}, device_with(kTranslations, 3.0));
  const DeviceWrench felt = lever.felt(wrench, DQuat(1.0, 0.0, 0.0, 0.0));
  EXPECT_LT(glm::distance(felt.force, DVec3(0.0, 2.5, 0.0)), kTiny);
  EXPECT_NEAR(felt.torque.z, 0.2 - 0.015, kTiny);
}

TEST(TorqueLever, ChangesNothingWhereItIsNotWanted) {
  const DeviceWrench wrench{{1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}};
  const DQuat turned = rotation_by({0.3, 0.2, 0.1});
  for (const TorqueLever& lever : {TorqueLever(), TorqueLever(DVec3(0.0), device_with(kTranslations, 3.0)),
                                   TorqueLever({0.0, 0.1, 0.0}, device_with(kAllDegrees, 3.0))}) {
    const DeviceWrench felt = lever.felt(wrench, turned);
    EXPECT_EQ(felt.force, wrench.force);
    EXPECT_EQ(felt.torque, wrench.torque);
  }
}

}  // namespace
}  // namespace palpate::test
