// Every limiter meets its fault on the way from a scene to a hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/haptic_loop/floor_loop.h"
#include "tests/support/allocation_count.h"
#include "tests/support/models.h"

namespace palpate::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class LoopFaults : public testing::Test {
 protected:
  void SetUp() override {
    loop_.tick_until_armed();
    resting_ = loop_.force().y;
    ASSERT_GT(resting_, 0.1);
  }

  std::uint64_t ticks_of(Limiter limiter) { return loop_.status().safety.ticks_of(limiter); }
  SafetyState state() { return loop_.status().safety.state; }

  // The fault is gone: after a pause, and softly, the hand feels the floor again.
  void expect_recovery() {
    loop_.device().set_fault(nullptr);
    double before = loop_.force().y;
    for (int i = 0; i < 2000; ++i) {
      loop_.tick();
      ASSERT_LT(std::abs(loop_.force().y - before), 0.02) << "a kick after " << i;
      before = loop_.force().y;
    }
    EXPECT_EQ(state(), SafetyState::kArmed);
    EXPECT_NEAR(loop_.force().y, resting_, 0.1);
  }

  FloorLoop loop_;
  double resting_ = 0.0;  // N
};

TEST_F(LoopFaults, PoseThatIsNotFinite) {
  const Pose before = loop_.scene().find(loop_.scene().tool())->pose();
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      loop_.device().set_fault([&](DeviceState state) {
        state.tool.position[axis] = bad;
        return state;
      });
      loop_.tick();
      ASSERT_EQ(loop_.force(), DVec3(0.0));
      ASSERT_EQ(state(), SafetyState::kFault);
    }
  }
  EXPECT_EQ(ticks_of(Limiter::kNonFinitePose), 9u);
  EXPECT_TRUE(std::isfinite(loop_.scene().contacts().wrench.force.y));
  const Pose after = loop_.scene().find(loop_.scene().tool())->pose();
  EXPECT_LT(glm::distance(after.translation, before.translation), 1e-3) << "the tool followed it";
  expect_recovery();
}

TEST_F(LoopFaults, OrientationThatIsNone) {
  loop_.device().set_fault([](DeviceState state) {
    state.tool.orientation = DQuat(0.0, 0.0, 0.0, 0.0);
    return state;
  });
  loop_.tick();
  EXPECT_EQ(loop_.force(), DVec3(0.0));
  EXPECT_EQ(ticks_of(Limiter::kNonFinitePose), 1u);
  expect_recovery();
}

TEST_F(LoopFaults, PoseThatJumps) {
  loop_.device().set_fault([](DeviceState state) {
    state.tool.position.y -= 0.02;
    return state;
  });
  loop_.tick();
  EXPECT_EQ(loop_.force(), DVec3(0.0));
  EXPECT_EQ(state(), SafetyState::kFault);
  EXPECT_EQ(ticks_of(Limiter::kPoseJump), 1u);
  expect_recovery();
}

TEST_F(LoopFaults, PoseThatIsStale) {
  const DeviceState last = loop_.device().phantom().read();
  loop_.device().set_fault([&](const DeviceState&) { return last; });
  for (int i = 0; i < 20; ++i) loop_.tick();
  EXPECT_EQ(loop_.force(), DVec3(0.0));
  EXPECT_EQ(state(), SafetyState::kFault);
  EXPECT_GT(ticks_of(Limiter::kStalePose), 5u);
  expect_recovery();
}

TEST_F(LoopFaults, ServoThatStalls) {
  loop_.tick(0.5);
  EXPECT_EQ(loop_.force(), DVec3(0.0));
  EXPECT_EQ(ticks_of(Limiter::kLongTick), 1u);
  for (const double odd : {kNan, -1.0, kInfinity}) loop_.tick(odd);
  EXPECT_EQ(ticks_of(Limiter::kLongTick), 4u);
  EXPECT_EQ(state(), SafetyState::kRamping);
  expect_recovery();
}

// Steps fail one after the other: the wrench before holds for ten milliseconds and no longer.
TEST_F(LoopFaults, SceneThatCannotBeStepped) {
  int failed = 0, pushed = 0;
  loop_.scene().add({.model = asset_model("box"), .pose = {}});
  for (int i = 0; i < 30; ++i) {
    const AllocationFailure no_memory;
    try {
      loop_.tick();
    } catch (const std::bad_alloc&) {
      ++failed;
    }
    pushed += loop_.force().y > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(failed, 30);
  EXPECT_NEAR(pushed, 10, 1) << "ten times a millisecond is rounded";
  EXPECT_EQ(state(), SafetyState::kFault);
  EXPECT_EQ(ticks_of(Limiter::kStaleServo), 30u - static_cast<unsigned>(pushed));
  EXPECT_EQ(loop_.status().ticks, 2030u);
}

TEST_F(LoopFaults, DeviceThatLosesItsCalibration) {
  loop_.device().set_fault([](DeviceState state) {
    state.calibrated = false;
    return state;
  });
  loop_.tick();
  EXPECT_EQ(loop_.force(), DVec3(0.0));
  EXPECT_EQ(state(), SafetyState::kDisarmed);
  expect_recovery();
}

TEST(AbsurdStiffness, StaysWithinTheDevice) {
  FloorLoop loop(1e12);
  loop.tick_until_armed();
  const DeviceLimits& limits = loop.device().info().limits;
  DVec3 before = loop.force();
  for (int i = 0; i < 3000; ++i) {
    loop.tick();
    ASSERT_LE(glm::length(loop.force()), limits.max_force * (1.0 + 1e-12)) << i;
    ASSERT_LE(glm::distance(loop.force(), before), 0.25 * limits.max_force * (1.0 + 1e-9)) << i;
    ASSERT_LE(glm::length(loop.device().written().torque), limits.max_torque * (1.0 + 1e-12)) << i;
    before = loop.force();
  }
  EXPECT_GT(loop.status().safety.ticks_of(Limiter::kForceClamp), 0u);
}

// A force that no number is: springs of the largest double, compressed.
TEST(AbsurdStiffness, BeyondAllNumbersIsAFault) {
  FloorLoop loop(std::numeric_limits<double>::max());
  loop.guarded().arm();
  DeviceMapping strong;
  strong.force_scale = 1e9;
  loop.loop().attach(loop.loop().detach(), strong);
  for (int i = 0; i < 500; ++i) {
    loop.tick();
    ASSERT_EQ(loop.force(), DVec3(0.0)) << i;
  }
  EXPECT_GT(loop.status().safety.ticks_of(Limiter::kNonFiniteWrench), 400u);
  EXPECT_EQ(loop.status().safety.state, SafetyState::kFault);
}

}  // namespace
}  // namespace palpate::test
