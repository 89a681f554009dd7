// What a device is told, in whose units and when, and what it tells.
#include <cmath>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "engine/device/openhaptics/openhaptics_backend.h"
#include "tests/device/openhaptics/phantom_loop.h"
#include "tests/support/allocation_count.h"

namespace palpate::test {
namespace {

std::unique_ptr<Device> open(const std::string& name) {
  auto opened = OpenHapticsBackend().open(StandInLibrary::in_library(name));
  EXPECT_TRUE(opened) << opened.error().message;
  return std::move(opened.value());
}

TEST(OpenHapticsFrames, SendNewtonsAndNewtonMillimetres) {
  StandInLibrary library;
  PhantomLoop loop(library);
  loop.want({{1.0, 2.0, -0.5}, {0.01, -0.02, 0.05}});
  ASSERT_TRUE(loop.engage());
  library.tick(100);
  const StandInRecord record = library.record();
  const double force[] = {1.0, 2.0, -0.5}, torque[] = {10.0, -20.0, 50.0};
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(record.force[i], force[i]);
    EXPECT_DOUBLE_EQ(record.torque[i], torque[i]);
    EXPECT_GT(record.handle[i] * force[i], 0.0) << "the hand gives way along the force";
  }
}

TEST(OpenHapticsFrames, TellMetresAndTurns) {
  const unsigned seed = std::random_device{}();
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-0.05, 0.05), turn(-1.2, 1.2);
  StandInLibrary library;
  PhantomLoop loop(library);
  for (int i = 0; i < 20; ++i) {
    const DVec3 wanted(place(random), place(random), place(random));
    library.plant([&](StandInFaults& faults) {
      for (int axis = 0; axis < 3; ++axis) faults.hand[axis] = wanted[axis];
      for (double& angle : faults.turn) angle = turn(random);
    });
    library.tick(2000);
    const StandInRecord record = library.record();
    const RigidMotion tool = loop.status().state.tool;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(tool.position[axis], record.handle[axis], 1e-12);
    const double* const turned = record.orientation;
    const double same = turned[0] * tool.orientation.x + turned[1] * tool.orientation.y +
                        turned[2] * tool.orientation.z + turned[3] * tool.orientation.w;
    EXPECT_NEAR(std::abs(same), 1.0, 1e-12);
    EXPECT_LT(glm::distance(tool.position, wanted), 2e-3) << "where the hand wants it, but for friction";
    EXPECT_LT(glm::length(tool.linear_velocity), 1e-2);
  }
}

TEST(OpenHapticsFrames, AreOneInEveryTick) {
  StandInLibrary library;
  {
    PhantomLoop loop(library);
    loop.want({{1.0, 0.0, 0.0}, {0.0, 0.0, 0.01}});
    ASSERT_TRUE(loop.engage());
    const StandInRecord before = library.record();
    library.tick(500);
    EXPECT_EQ(library.record().frames, before.frames + 500);
    loop.device().servo_host()->put_down();
    library.tick(500);
    EXPECT_EQ(library.record().frames, before.frames + 1000) << "whether or not a servo is there";
  }
  EXPECT_EQ(library.record().missed_frames, 0u);
  EXPECT_EQ(library.record().sets_outside, 0u);
}

// Pushes by the number of the sample, so that what was sent tells from which one it was computed.
class Numbering final : public ServoTask {
 public:
  static constexpr double kStep = 1e-4;  // N

  explicit Numbering(Device& device) : device_(device) {}
  void tick(double) noexcept override {
    seen = device_.read().sequence;
    device_.write({{kStep * static_cast<double>(seen), 0.0, 0.0}, DVec3(0.0)});
  }

  std::uint64_t seen = 0;

 private:
  Device& device_;
};

TEST(OpenHapticsFrames, AServoOnTheLoopIsNotLate) {
  StandInLibrary library;
  const auto device = open("Default Device");
  Numbering servo(*device);
  device->servo_host()->carry(servo);
  std::uint64_t before = device->read().sequence;
  for (int i = 0; i < 50; ++i) {
    library.tick();
    ASSERT_EQ(servo.seen, ++before);
    ASSERT_EQ(library.record().force[0], Numbering::kStep * static_cast<double>(servo.seen));
  }
  device->servo_host()->put_down();
}

TEST(OpenHapticsFrames, AServoElsewhereIsOneTickLate) {
  StandInLibrary library;
  const auto device = open("Default Device");
  Numbering servo(*device);
  servo.tick(1e-3);
  for (int i = 0; i < 50; ++i) {
    library.tick();
    ASSERT_EQ(library.record().force[0], Numbering::kStep * static_cast<double>(servo.seen));
    servo.tick(1e-3);
  }
}

TEST(OpenHapticsFrames, AWrenchThatNobodyRenewsEnds) {
  StandInLibrary library;
  const auto device = open("Default Device");
  device->write({{2.0, 0.0, 0.0}, DVec3(0.0)});
  library.tick(8);
  EXPECT_EQ(library.record().force[0], 2.0);
  library.tick(4);
  EXPECT_EQ(library.record().force[0], 0.0);
  library.tick(100);
  EXPECT_EQ(library.record().force[0], 0.0);
}

// Not even without the limits before it is a device told what it cannot do.
TEST(OpenHapticsFrames, NeverAskForMoreThanTheDeviceCan) {
  StandInLibrary library;
  const auto device = open("Default Device");
  for (const double scale : {1.0, 1e3, 1e300}) {
    device->write({scale * DVec3(7.0, 8.0, 9.0), scale * DVec3(1.0)});
    library.tick();
    EXPECT_LE(sent_force(library.record()), 8.5 * (1.0 + 1e-12));
    EXPECT_LE(std::hypot(library.record().torque[0], library.record().torque[1]), 188.0);
  }
  device->write({DVec3(std::nan("")), DVec3(0.0)});
  library.tick();
  EXPECT_EQ(sent_force(library.record()), 0.0);
  EXPECT_EQ(device->glance()->condition, DeviceCondition::kReady);
}

TEST(OpenHapticsFrames, ATouchIsNotTroubledWithTorque) {
  StandInLibrary library;
  PhantomLoop loop(library, "Left");
  loop.want({{0.0, 1.0, 0.0}, {0.0, 0.02, 0.0}});
  ASSERT_TRUE(loop.engage());
  EXPECT_TRUE(loop.status().unactuated) << "it is said that torque was dropped";
  EXPECT_EQ(loop.status().applied.torque, DVec3(0.0));
  EXPECT_EQ(library.record(1).force[1], 1.0);
  EXPECT_EQ(library.record(1).torques_refused, 0u);
}

TEST(OpenHapticsFrames, AllocateNothing) {
  StandInLibrary library;
  PhantomLoop loop(library);
  loop.want({{1.0, 0.0, 0.0}, DVec3(0.0)});
  ASSERT_TRUE(loop.engage());
  const std::uint64_t before = allocation_count();
  library.tick(500);
  EXPECT_EQ(allocation_count(), before);
}

TEST(OpenHapticsFrames, EndWithTheDevice) {
  StandInLibrary library;
  {
    PhantomLoop loop(library);
    loop.want({{1.0, 0.0, 0.0}, DVec3(0.0)});
    ASSERT_TRUE(loop.engage());
    EXPECT_TRUE(library.record().open);
  }
  const StandInRecord record = library.record();
  EXPECT_FALSE(record.open);
  EXPECT_FALSE(record.output);
  library.tick(10);
  EXPECT_EQ(library.record().pushes, record.pushes);
  EXPECT_EQ(library.record().frames, record.frames) << "no callback runs";
}

TEST(OpenHapticsFacts, AreTheDevices) {
  StandInLibrary library;
  const auto premium = open("Default Device"), touch = open("Left");
  const DeviceInfo& info = premium->info();
  EXPECT_EQ(info.identity.uri, StandInLibrary::uri("Default Device"));
  EXPECT_EQ(info.identity.name, "PHANTOM Premium 1.5 6DOF");
  EXPECT_EQ(info.identity.serial, "S-1234");
  EXPECT_EQ(info.capabilities.actuated, kAllDegrees);
  EXPECT_EQ(info.limits.max_force, 8.5);
  EXPECT_EQ(info.limits.continuous_force, 1.4);
  EXPECT_DOUBLE_EQ(info.limits.max_torque, 0.188);
  EXPECT_DOUBLE_EQ(info.limits.max_stiffness, 800.0);
  EXPECT_DOUBLE_EQ(info.limits.max_damping, 5.0);
  EXPECT_EQ(info.limits.update_rate, 1000.0);
  EXPECT_NEAR(info.limits.workspace.size().x, 0.381, 1e-12);
  EXPECT_EQ(touch->info().capabilities.actuated, kTranslations);
  EXPECT_EQ(touch->info().limits.max_force, 3.3);
  EXPECT_EQ(touch->info().limits.max_torque, 0.0);
  EXPECT_EQ(touch->info().capabilities.buttons, 3) << "with the one of the inkwell";
}

// A device that speaks of its torque in newton-metres, or boasts, is held to less than either.
TEST(OpenHapticsFacts, LimitsAreTheTighterOnes) {
  for (const double times : {1e-3, 0.5, 1.0, 10.0, 1e3}) {
    StandInLibrary library;
    library.plant(
        [times](StandInFaults& faults) { faults.force_limits_times = faults.torque_limits_times = times; });
    const auto device = open("Default Device");
    EXPECT_DOUBLE_EQ(device->info().limits.max_force, 8.5 * std::min(times, 1.0));
    EXPECT_DOUBLE_EQ(device->info().limits.max_torque, 0.188 * std::min(times, 1.0));
  }
  StandInLibrary library;
  library.plant([](StandInFaults& faults) { faults.force_limits_times = faults.torque_limits_times = -1.0; });
  EXPECT_EQ(open("Default Device")->info().limits.max_force, 8.5) << "no limit is one";
}

TEST(OpenHapticsDevices, AreSeveralOnOneScheduler) {
  StandInLibrary library;
  PhantomLoop premium(library), touch(library, "Left");
  premium.want({{1.0, 0.0, 0.0}, {0.0, 0.0, 0.1}});
  touch.want({{0.0, 2.0, 0.0}, DVec3(0.0)});
  ASSERT_TRUE(premium.engage());
  ASSERT_TRUE(touch.engage());
  library.tick();
  EXPECT_EQ(library.record(0).force[0], 1.0);
  EXPECT_DOUBLE_EQ(library.record(0).torque[2], 100.0);
  EXPECT_EQ(library.record(0).force[1], 0.0);
  EXPECT_EQ(library.record(1).force[1], 2.0);
  EXPECT_EQ(library.record(1).force[0], 0.0);
}

}  // namespace
}  // namespace palpate::test
