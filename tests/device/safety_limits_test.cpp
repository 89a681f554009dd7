#include "engine/device/safety_limits.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "engine/device/rotation_vector.h"
#include "engine/device/simulated/phantom_spec.h"

namespace palpate {
namespace {

constexpr double kTick = 1e-3;
const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinite = std::numeric_limits<double>::infinity();

// Limits of a Premium, with a servo and a device that tick well until a test injects a fault.
class SafetyLimitsTest : public testing::Test {
 protected:
  void SetUp() override {
    state_.calibrated = true;
    command_.wrench.force = {1.0, 0.0, 0.0};
    limits_.arm();
  }

  // A sound tick: a new wrench and a new sample.
  DeviceWrench tick(double dt = kTick) {
    ++command_.sequence;
    ++state_.sequence;
    state_.time += kTick;
    return limits_.apply(command_, state_, dt);
  }

  void tick_for(double seconds) {
    for (int i = 0; i < std::lround(seconds / kTick); ++i) tick();
  }

  void arm_fully() {
    tick_for(0.8);
    ASSERT_EQ(state(), SafetyState::kArmed);
  }

  SafetyState state() const { return limits_.report().state; }
  bool is_acting(Limiter limiter) const { return limits_.report().is_acting(limiter); }
  std::uint64_t ticks_of(Limiter limiter) const { return limits_.report().ticks_of(limiter); }

  // After a fault that has just gone: silence for the hold, then a ramp from nothing to everything.
  void expect_soft_return() {
    for (int i = 0; i < 99; ++i) ASSERT_EQ(tick().force, DVec3(0.0)) << i;
    tick_for(0.005);
    EXPECT_EQ(state(), SafetyState::kRamping);
    double before = 0.0;
    for (int i = 0; i < 740; ++i) {
      const double now = tick().force.x;
      ASSERT_GE(now, before);
      ASSERT_LT(now - before, 2.5e-3) << "a ramp of 0.75 s, without a kick";
      before = now;
    }
    tick_for(0.05);
    EXPECT_EQ(state(), SafetyState::kArmed);
    EXPECT_EQ(tick().force.x, 1.0);
  }

  // The wrench that has just been returned, and what the report says of it.
  void expect_fault(const DeviceWrench& out, Limiter cause) {
    EXPECT_EQ(out.force, DVec3(0.0));
    EXPECT_EQ(out.torque, DVec3(0.0));
    EXPECT_EQ(state(), SafetyState::kFault);
    EXPECT_EQ(limits_.report().gain, 0.0);
    EXPECT_TRUE(is_acting(cause));
    EXPECT_EQ(ticks_of(cause), 1u);
  }

  SafetySettings settings_ = SafetySettings::for_device(premium6dof_spec().limits);
  SafetyLimits limits_{settings_};
  SafetyLimits::Command command_;
  DeviceState state_;
};

TEST_F(SafetyLimitsTest, PassOnWhatIsWithinThemUnchanged) {
  command_.wrench = {DVec3(1.1, -0.7, 0.3), DVec3(0.01, 0.02, -0.03)};
  arm_fully();
  const DeviceWrench out = tick();
  EXPECT_EQ(out.force, command_.wrench.force);
  EXPECT_EQ(out.torque, command_.wrench.torque);
  for (const bool acting : limits_.report().acting) EXPECT_FALSE(acting);
}

TEST_F(SafetyLimitsTest, GiveNothingUntilArmed) {
  limits_.disarm();
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(tick().force, DVec3(0.0));
  EXPECT_EQ(state(), SafetyState::kDisarmed);
  limits_.arm();
  arm_fully();
  limits_.disarm();
  EXPECT_EQ(tick().force, DVec3(0.0));
  EXPECT_EQ(state(), SafetyState::kDisarmed);
}

TEST_F(SafetyLimitsTest, GiveNothingToADeviceThatIsNotCalibrated) {
  arm_fully();
  state_.calibrated = false;
  EXPECT_EQ(tick().force, DVec3(0.0));
  EXPECT_EQ(state(), SafetyState::kDisarmed);
  state_.calibrated = true;
  tick_for(0.1);
  EXPECT_EQ(state(), SafetyState::kRamping);
}

TEST_F(SafetyLimitsTest, GiveNothingWhenTheDeadManSwitchIsLetGo) {
  settings_.dead_man = 0b10;
  limits_ = SafetyLimits(settings_);
  limits_.arm();
  state_.buttons = 0b01;
  tick_for(1.0);
  EXPECT_EQ(state(), SafetyState::kDisarmed);
  state_.buttons = 0b11;
  arm_fully();
  state_.buttons = 0b01;
  EXPECT_EQ(tick().force, DVec3(0.0));
}

TEST_F(SafetyLimitsTest, EngageSoftly) {
  command_.wrench.torque = {0.0, 0.1, 0.0};
  double before = 0.0;
  for (int i = 0; i < 751; ++i) {
    const DeviceWrench out = tick();
    const double now = out.force.x;
    ASSERT_GE(now, before);
    ASSERT_LT(now - before, 2.5e-3);
    if (i > 20) {
      ASSERT_DOUBLE_EQ(out.torque.y, 0.1 * now);
    }
    before = now;
    if (i == 375) {
      EXPECT_NEAR(now, 0.5, 0.01);
    }
  }
  EXPECT_EQ(before, 1.0);
  EXPECT_EQ(ticks_of(Limiter::kRamp), 750u);
}

TEST_F(SafetyLimitsTest, TurnAWrenchThatIsNoNumberIntoAFault) {
  const DeviceWrench broken[] = {{DVec3(kNan, 0.0, 0.0), DVec3(0.0)},
                                 {DVec3(0.0, kInfinite, 0.0), DVec3(0.0)},
                                 {DVec3(1.0), DVec3(0.0, 0.0, kNan)}};
  for (const DeviceWrench& wrench : broken) {
    limits_ = SafetyLimits(settings_);
    limits_.arm();
    arm_fully();
    const DeviceWrench sound = command_.wrench;
    command_.wrench = wrench;
    expect_fault(tick(), Limiter::kNonFiniteWrench);
    command_.wrench = sound;
    expect_soft_return();
  }
}

TEST_F(SafetyLimitsTest, TurnAPoseThatIsNoNumberIntoAFault) {
  std::vector<RigidMotion> broken(4);
  broken[0].position.z = kNan;
  broken[1].orientation = DQuat(0.0, 0.0, 0.0, 0.0);
  broken[2].linear_velocity.x = kInfinite;
  broken[3].orientation.x = kNan;
  for (const RigidMotion& tool : broken) {
    limits_ = SafetyLimits(settings_);
    limits_.arm();
    arm_fully();
    state_.tool = tool;
    expect_fault(tick(), Limiter::kNonFinitePose);
    state_.tool = {};
    expect_soft_return();
  }
}

TEST_F(SafetyLimitsTest, TurnAStalePoseIntoAFault) {
  arm_fully();
  for (int i = 1; i <= 10; ++i) {
    ++command_.sequence;
    ASSERT_EQ(limits_.apply(command_, state_, kTick * 0.999).force.x, 1.0) << i;
  }
  ++command_.sequence;
  expect_fault(limits_.apply(command_, state_, kTick), Limiter::kStalePose);
  EXPECT_FALSE(is_acting(Limiter::kStaleServo));
  expect_soft_return();
}

TEST_F(SafetyLimitsTest, TurnAServoThatHangsIntoAFault) {
  arm_fully();
  for (int i = 1; i <= 10; ++i) {
    ++state_.sequence;
    ASSERT_EQ(limits_.apply(command_, state_, kTick * 0.999).force.x, 1.0) << i;
  }
  ++state_.sequence;
  expect_fault(limits_.apply(command_, state_, kTick), Limiter::kStaleServo);
  EXPECT_FALSE(is_acting(Limiter::kStalePose));
  expect_soft_return();
}

TEST_F(SafetyLimitsTest, TurnWhatTheDeviceReportsIntoAFault) {
  for (const DeviceCondition condition :
       {DeviceCondition::kWarmMotors, DeviceCondition::kExceededForce, DeviceCondition::kExceededVelocity,
        DeviceCondition::kLost, DeviceCondition::kFailed}) {
    limits_ = SafetyLimits(limits_.settings());
    limits_.arm();
    arm_fully();
    state_.condition = condition;
    expect_fault(tick(), Limiter::kDevice);
    state_.condition = DeviceCondition::kReady;
    expect_soft_return();
  }
}

TEST_F(SafetyLimitsTest, TurnAJumpInPoseIntoAFault) {
  arm_fully();
  state_.tool.position.x += 0.05;
  expect_fault(tick(), Limiter::kPoseJump);
  expect_soft_return();
}

TEST_F(SafetyLimitsTest, TurnAJumpInOrientationIntoAFault) {
  arm_fully();
  state_.tool.orientation = rotation_by(DVec3(0.0, 0.5, 0.0));
  expect_fault(tick(), Limiter::kPoseJump);
  expect_soft_return();
}

TEST_F(SafetyLimitsTest, TurnAnImplausibleVelocityIntoAFault) {
  arm_fully();
  state_.tool.linear_velocity.z = 5.1;
  expect_fault(tick(), Limiter::kPoseJump);
  state_.tool = {};
  expect_soft_return();
}

TEST_F(SafetyLimitsTest, SeeAJumpBehindAWildTimeStamp) {
  arm_fully();
  state_.tool.position.x += 0.06;
  state_.time += 1e6;
  expect_fault(tick(), Limiter::kPoseJump);
}

TEST_F(SafetyLimitsTest, AllowTheFastestHand) {
  arm_fully();
  for (int i = 0; i < 50; ++i) {
    state_.tool.position.x += 3e-3;
    state_.tool.orientation = slightly_turned(state_.tool.orientation, DVec3(0.0, 0.03, 0.0));
    ASSERT_EQ(tick().force.x, 1.0) << "3 m/s and 30 rad/s";
  }
}

// A wall of 1e15 N/m, met at one nanometre more each tick.
TEST_F(SafetyLimitsTest, HoldAnAbsurdStiffnessToTheDevice) {
  command_.wrench = {};
  arm_fully();
  const DVec3 normal = glm::normalize(DVec3(0.3, 1.0, -0.2));
  DVec3 before(0.0);
  for (int i = 1; i <= 50; ++i) {
    command_.wrench = {1e15 * 1e-9 * i * normal, 1e12 * normal};
    const DeviceWrench out = tick();
    EXPECT_LE(glm::distance(out.force, before), settings_.force_slew * (1.0 + 1e-12)) << i;
    EXPECT_TRUE(is_acting(Limiter::kForceClamp));
    EXPECT_TRUE(is_acting(Limiter::kTorqueClamp));
    before = out.force;
  }
  EXPECT_LT(glm::distance(before, settings_.max_force * normal), 1e-12);
  EXPECT_EQ(ticks_of(Limiter::kForceSlew), 3u) << "full scale in four milliseconds";
}

TEST_F(SafetyLimitsTest, ClampForceAndTorqueEachAndKeepTheirDirections) {
  const DVec3 along = glm::normalize(DVec3(-1.0, 2.0, 2.0));
  command_.wrench = {20.0 * along, DVec3(0.0, 0.01, 0.0)};
  arm_fully();
  const DeviceWrench force_clamped = tick();
  EXPECT_LT(glm::distance(force_clamped.force, 8.5 * along), 1e-12);
  EXPECT_EQ(force_clamped.torque, command_.wrench.torque);
  EXPECT_FALSE(is_acting(Limiter::kTorqueClamp));
  command_.wrench = {along, along};
  tick_for(0.02);
  const DeviceWrench torque_clamped = tick();
  EXPECT_EQ(torque_clamped.force, along);
  EXPECT_LT(glm::distance(torque_clamped.torque, 0.188 * along), 1e-12);
}

TEST_F(SafetyLimitsTest, ClampWhatOverflowsWhenSquared) {
  command_.wrench.force = {3e300, -4e300, 0.0};
  arm_fully();
  EXPECT_LT(glm::distance(tick().force, DVec3(0.6 * 8.5, -0.8 * 8.5, 0.0)), 1e-12);
}

TEST_F(SafetyLimitsTest, SlewAtTheSameRateWhateverTheTick) {
  for (const double dt : {0.25e-3, 1e-3, 2e-3}) {
    limits_ = SafetyLimits(settings_);
    limits_.arm();
    command_.wrench = {};
    while (state() != SafetyState::kArmed) tick(dt);
    command_.wrench = {DVec3(8.0, 0.0, 0.0), DVec3(0.0, 0.0, 0.15)};
    const DeviceWrench out = tick(dt);
    EXPECT_NEAR(out.force.x, settings_.force_slew * 1e3 * dt, 1e-12);
    EXPECT_NEAR(out.torque.z, settings_.torque_slew * 1e3 * dt, 1e-12);
    EXPECT_TRUE(is_acting(Limiter::kForceSlew));
    EXPECT_TRUE(is_acting(Limiter::kTorqueSlew));
  }
}

TEST_F(SafetyLimitsTest, ReturnToTheRampAfterABreakpoint) {
  for (const double dt : {0.5, -kTick, kNan, kInfinite}) {
    limits_ = SafetyLimits(settings_);
    limits_.arm();
    arm_fully();
    EXPECT_EQ(tick(dt).force, DVec3(0.0));
    EXPECT_EQ(state(), SafetyState::kRamping) << "no fault: nothing is wrong with the device";
    EXPECT_EQ(ticks_of(Limiter::kLongTick), 1u);
    EXPECT_LT(tick().force.x, 1e-3);
    tick_for(0.75);
    EXPECT_EQ(tick().force.x, 1.0);
  }
}

TEST_F(SafetyLimitsTest, AllowTheHandleToBeElsewhereAfterABreakpoint) {
  arm_fully();
  state_.tool.position.x += 0.1;
  tick(0.5);
  EXPECT_EQ(state(), SafetyState::kRamping);
  EXPECT_EQ(ticks_of(Limiter::kPoseJump), 0u);
}

TEST_F(SafetyLimitsTest, ForgetTheForceFromBeforeTheRamp) {
  const auto let_go = [this] {
    limits_.disarm();
    tick();
    limits_.arm();
  };
  const auto jump = [this] { state_.tool.position.x += 0.05; };
  const auto pause = [this] { tick(0.5); };
  for (const std::function<void()>& interrupt : {std::function<void()>(let_go), {jump}, {pause}}) {
    command_.wrench.force = {8.0, 0.0, 0.0};
    tick_for(1.0);
    ASSERT_EQ(state(), SafetyState::kArmed);
    command_.wrench.force = {-8.0, 0.0, 0.0};
    interrupt();
    for (int i = 0; i < 300; ++i) ASSERT_LE(tick().force.x, 0.0) << i;
    tick_for(1.0);
    EXPECT_EQ(tick().force.x, -8.0);
    command_.wrench.force = {0.0, 0.0, 0.0};
    tick_for(0.1);
  }
}

TEST_F(SafetyLimitsTest, StayInFaultWhileItsCauseReturns) {
  arm_fully();
  for (int i = 0; i < 20; ++i) {
    state_.tool.position.x += 0.05;
    tick();
    for (int quiet = 0; quiet < 90; ++quiet) ASSERT_EQ(tick().force, DVec3(0.0));
  }
  EXPECT_EQ(ticks_of(Limiter::kPoseJump), 20u);
  EXPECT_EQ(state(), SafetyState::kFault);
}

// Wrenches and poses of all sizes, some not finite, with gaps in both sequences.
class Abuse {
 public:
  explicit Abuse(std::uint64_t seed) : generator_(seed) {}

  DeviceWrench tick(SafetyLimits& limits) {
    if (chance(0.95)) ++command_.sequence;
    if (chance(0.95)) ++state_.sequence;
    command_.wrench = {vector(), vector()};
    if (chance(0.001)) command_.wrench.torque.x = kNan;
    if (chance(0.001)) state_.tool.position.y += 1.0;
    state_.calibrated = true;
    state_.time += kTick;
    return limits.apply(command_, state_, chance(0.001) ? 1.0 : kTick);
  }

 private:
  double uniform() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  bool chance(double probability) { return uniform() < probability; }
  DVec3 vector() {
    const double size = std::pow(10.0, 24.0 * uniform() - 12.0);
    return size * (DVec3(uniform(), uniform(), uniform()) - 0.5);
  }

  std::mt19937_64 generator_;
  SafetyLimits::Command command_;
  DeviceState state_;
};

TEST_F(SafetyLimitsTest, HoldUnderAbuse) {
  Abuse abuse(20240517);
  int with_force = 0;
  for (int i = 0; i < 100000; ++i) {
    const DeviceWrench out = abuse.tick(limits_);
    ASSERT_LE(glm::length(out.force), settings_.max_force * (1.0 + 1e-12)) << i;
    ASSERT_LE(glm::length(out.torque), settings_.max_torque * (1.0 + 1e-12)) << i;
    with_force += glm::length(out.force) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(with_force, 10000);
  for (const Limiter limiter : {Limiter::kLongTick, Limiter::kNonFiniteWrench, Limiter::kPoseJump}) {
    EXPECT_GT(ticks_of(limiter), 0u);
  }
}

TEST_F(SafetyLimitsTest, RepeatThemselvesBitByBit) {
  SafetyLimits other(settings_);
  other.arm();
  Abuse first(7), second(7);
  for (int i = 0; i < 20000; ++i) {
    const DeviceWrench a = first.tick(limits_), b = second.tick(other);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(a.force[axis]), std::bit_cast<std::uint64_t>(b.force[axis]));
      ASSERT_EQ(std::bit_cast<std::uint64_t>(a.torque[axis]), std::bit_cast<std::uint64_t>(b.torque[axis]));
    }
  }
}

}  // namespace
}  // namespace palpate
