#include "engine/device/simulated/encoder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/device/rotation_vector.h"

namespace palpate {
namespace {

constexpr double kTick = 1e-3;
constexpr double kCount = 50e-6;     // m
constexpr double kTurnCount = 4e-3;  // rad
const double kTurnError = 0.5 * std::sqrt(3.0) * kTurnCount * (1.0 + 1e-4);

RigidMotion at(const DVec3& position, const DQuat& orientation) {
  RigidMotion motion;
  motion.position = position;
  motion.orientation = orientation;
  return motion;
}

TEST(Encoder, IsWithinHalfACountAtEveryOrientation) {
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  Encoder encoder(kCount, kTurnCount);
  for (int i = 0; i < 20000; ++i) {
    const DQuat about_x = rotation_by(DVec3(angle(generator), 0.0, 0.0));
    const DQuat about_y = rotation_by(DVec3(0.0, i % 2 == 0 ? std::acos(0.0) : angle(generator), 0.0));
    const DQuat about_z = rotation_by(DVec3(0.0, 0.0, angle(generator)));
    const DQuat orientation = about_z * about_y * about_x;
    const RigidMotion read = encoder.sample(at(DVec3(0.0), orientation), kTick);
    ASSERT_LE(glm::length(rotation_between(read.orientation, orientation)), kTurnError) << i;
    ASSERT_NEAR(glm::length(read.orientation), 1.0, 1e-12);
  }
}

TEST(Encoder, StandsStillWithinACount) {
  Encoder encoder(kCount, kTurnCount);
  encoder.reset(at(DVec3(3.0 * kCount), DQuat(1.0, 0.0, 0.0, 0.0)));
  for (const double part : {-0.49, 0.3, 0.49}) {
    const RigidMotion moved =
        at(DVec3((3.0 + part) * kCount), rotation_by(DVec3(0.0, part * kTurnCount, 0.0)));
    const RigidMotion read = encoder.sample(moved, kTick);
    EXPECT_EQ(read.linear_velocity, DVec3(0.0));
    EXPECT_EQ(read.angular_velocity, DVec3(0.0));
  }
  const RigidMotion beyond = at(DVec3(3.51 * kCount), rotation_by(DVec3(0.0, 0.51 * kTurnCount, 0.0)));
  const RigidMotion read = encoder.sample(beyond, kTick);
  EXPECT_DOUBLE_EQ(read.position.x, 4.0 * kCount);
  EXPECT_NEAR(rotation_vector(read.orientation).y, kTurnCount, 1e-12);
  EXPECT_GT(read.linear_velocity.x, 0.0);
  EXPECT_GT(read.angular_velocity.y, 0.0);
}

TEST(Encoder, ReadsTheSameAfterAResetWhateverWasBefore) {
  const RigidMotion place = at(DVec3(0.01), rotation_by(DVec3(0.3, -0.7, 0.2)));
  Encoder used(kCount, kTurnCount), fresh(kCount, kTurnCount);
  used.reset(at(DVec3(0.02), rotation_by(DVec3(1.0, 0.123, -0.5))));
  used.reset(place);
  fresh.reset(place);
  EXPECT_EQ(used.last().position, fresh.last().position);
  EXPECT_EQ(used.last().orientation, fresh.last().orientation);
}

// A first-order low pass of 100 Hz reaches 1 − 1/e of a step of velocity after 1.6 ms.
TEST(Encoder, SmoothsVelocityByALowPass) {
  const double fine = 1e-4;
  const double speed = 0.2, turn_rate = 2.0;
  Encoder encoder(1e-12, 1e-12);
  encoder.reset({});
  RigidMotion read;
  for (int i = 1; i <= 16; ++i) {
    const double t = fine * i;
    read = encoder.sample(at(DVec3(speed * t, 0.0, 0.0), rotation_by(DVec3(0.0, 0.0, turn_rate * t))), fine);
  }
  const double reached = 1.0 - std::exp(-2.0 * std::acos(-1.0) * 100.0 * 1.6e-3);
  EXPECT_NEAR(read.linear_velocity.x, reached * speed, 1e-6);
  EXPECT_NEAR(read.angular_velocity.z, reached * turn_rate, 1e-6);
}

}  // namespace
}  // namespace palpate
