#include <gtest/gtest.h>

#include <cmath>

#include "engine/device/hid/ohhp_sample.h"
#include "engine/device/hid/ohhp_wrench.h"
#include "samples/hid_device/haptic_device.h"

// The device that users learn the protocol from: when it pushes, and when it lets go.
namespace palpate {
namespace {

constexpr double kPush = 1.0;    // N
constexpr double kLife = 0.010;  // s
constexpr int kRamp = 100;       // samples
constexpr int kWatchdog = 10;    // samples

class ReferenceDevice : public testing::Test {
 protected:
  OhhpSample step() {
    const auto sample = parse_ohhp_sample(device_.step());
    EXPECT_TRUE(sample);
    return sample.value_or(OhhpSample{});
  }

  bool command(OhhpCommand::Kind kind, std::uint16_t milliseconds = 0) {
    return device_.take_command(ohhp_report(OhhpCommand{kind, milliseconds}));
  }

  bool push(double force = kPush) { return push_for(device_.sequence(), force); }

  bool push_for(std::uint16_t answered, double force = kPush) {
    return device_.take_wrench(
        ohhp_report(OhhpWrench{{DVec3(0.0, force, 0.0), DVec3(0.0)}, answered, kLife}));
  }

  OhhpSample push_steps(int count) {
    OhhpSample sample;
    for (int i = 0; i < count; ++i) {
      EXPECT_TRUE(push());
      sample = step();
    }
    return sample;
  }

  void arm() {
    ASSERT_TRUE(command(OhhpCommand::Kind::kArm));
    push_steps(kRamp + 1);
    ASSERT_NEAR(force(), kPush, 1e-6);
  }

  double force() const { return device_.force()[1]; }

  hid_device::HapticDevice device_;
};

TEST_F(ReferenceDevice, PushesOnlyWhileArmed) {
  push_steps(200);
  EXPECT_EQ(force(), 0.0);
  arm();
  ASSERT_TRUE(command(OhhpCommand::Kind::kDisarm));
  EXPECT_FALSE(push_steps(1).has(OhhpSample::kArmed));
  EXPECT_EQ(force(), 0.0);
}

TEST_F(ReferenceDevice, ForceFadesIn) {
  ASSERT_TRUE(command(OhhpCommand::Kind::kArm));
  double before = 0.0;
  for (int i = 0; i < kRamp; ++i) {
    push_steps(1);
    EXPECT_GT(force(), before);
    EXPECT_LT(force() - before, 1.5 * kPush / kRamp);
    before = force();
  }
}

TEST_F(ReferenceDevice, LetsGoWhereNoWrenchComesAndFadesInAnew) {
  arm();
  OhhpSample sample;
  for (int i = 0; i < kWatchdog; ++i) sample = step();
  EXPECT_TRUE(sample.has(OhhpSample::kWatchdog) && sample.has(OhhpSample::kArmed));
  EXPECT_EQ(force(), 0.0);
  EXPECT_FALSE(push_steps(1).has(OhhpSample::kWatchdog));
  EXPECT_LT(force(), 2.0 * kPush / kRamp);
}

TEST_F(ReferenceDevice, AWrenchThatWasHeldUpIsDead) {
  arm();
  const std::uint16_t old = device_.sequence();
  for (int i = 0; i < 2 * kWatchdog; ++i) step();
  EXPECT_TRUE(push_for(old));
  step();
  EXPECT_EQ(force(), 0.0);
  for (int i = 0; i < 100; ++i) step();
  EXPECT_FALSE(push_for(old)) << "too old to be told from one of the future";
  EXPECT_FALSE(push_for(static_cast<std::uint16_t>(device_.sequence() + 1)));
}

TEST_F(ReferenceDevice, EmergencyHeatAndDeadManLetGo) {
  arm();
  device_.hold_dead_man(false);
  push_steps(1);
  EXPECT_EQ(force(), 0.0);
  device_.hold_dead_man(true);
  device_.press_emergency_stop(true);
  EXPECT_TRUE(push_steps(1).has(OhhpSample::kEmergency));
  EXPECT_FALSE(device_.armed());
  EXPECT_FALSE(command(OhhpCommand::Kind::kArm));
  device_.press_emergency_stop(false);
  push_steps(200);
  EXPECT_EQ(force(), 0.0) << "who pressed it arms it again";
  arm();
  device_.set_temperature(255);
  EXPECT_TRUE(push_steps(1).has(OhhpSample::kTooHot));
  EXPECT_EQ(force(), 0.0);
}

TEST_F(ReferenceDevice, ArmsOnlyOnceCalibrated) {
  hid_device::Features features;
  features.traits = 2;
  hid_device::HapticDevice device(features);
  const auto command = [&](OhhpCommand::Kind kind) {
    return device.take_command(ohhp_report(OhhpCommand{kind}));
  };
  EXPECT_FALSE(command(OhhpCommand::Kind::kArm));
  EXPECT_FALSE(parse_ohhp_sample(device.step())->has(OhhpSample::kCalibrated));
  EXPECT_TRUE(command(OhhpCommand::Kind::kCalibrate));
  EXPECT_TRUE(command(OhhpCommand::Kind::kArm));
  EXPECT_FALSE(command(OhhpCommand::Kind::kCalibrate)) << "not while it pushes";
}

TEST_F(ReferenceDevice, ForceBeyondItsOwnSaturatesWithItsDirection) {
  ASSERT_TRUE(command(OhhpCommand::Kind::kArm));
  for (int i = 0; i <= kRamp; ++i) {
    ASSERT_TRUE(device_.take_wrench(
        ohhp_report(OhhpWrench{{DVec3(30.0, 40.0, 0.0), DVec3(0.0)}, device_.sequence(), kLife})));
    step();
  }
  EXPECT_NEAR(device_.force()[0], 3.0, 1e-6);
  EXPECT_NEAR(device_.force()[1], 4.0, 1e-6);
  EXPECT_TRUE(step().has(OhhpSample::kSaturated));
}

TEST_F(ReferenceDevice, TheWatchdogIsSetButNeverLengthened) {
  EXPECT_TRUE(command(OhhpCommand::Kind::kSetWatchdog, 5));
  EXPECT_FALSE(command(OhhpCommand::Kind::kSetWatchdog, 0));
  EXPECT_FALSE(command(OhhpCommand::Kind::kSetWatchdog, 1000));
  arm();
  for (int i = 0; i < 5; ++i) step();
  EXPECT_EQ(force(), 0.0);
}

TEST_F(ReferenceDevice, TheMassMovesAsItIsPushed) {
  arm();
  push_steps(1000);
  EXPECT_GT(device_.mass().motion().position[1], 1e-3);
  EXPECT_LT(std::abs(device_.mass().motion().velocity[1]), 1e-3);
}

}  // namespace
}  // namespace palpate
