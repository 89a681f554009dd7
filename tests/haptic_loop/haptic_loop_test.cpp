#include "engine/runtime/haptic_loop.h"

#include <gtest/gtest.h>

#include <bit>

#include "engine/device/simulated/scripted_motion.h"
#include "tests/haptic_loop/floor_loop.h"
#include "tests/support/allocation_count.h"
#include "tests/support/models.h"

namespace palpate::test {
namespace {

TEST(HapticLoop, MovesTheToolAndPushesTheHand) {
  FloorLoop loop;
  loop.tick_until_armed();
  const Body& tool = *loop.scene().find(loop.scene().tool());
  const DeviceStatus status = loop.status();
  EXPECT_EQ(tool.pose().translation, status.state.tool.position);
  EXPECT_EQ(status.wanted.force, loop.scene().contacts().wrench.force) << "one scale, one frame";
  // In equilibrium, but for friction, the hand presses as the floor does.
  const double hand = impedance_of(Grip::kLight).stiffness * loop.device().phantom().true_motion().position.y;
  EXPECT_NEAR(loop.force().y, hand, premium6dof_spec().handle.friction + 0.02);
  EXPECT_EQ(status.ticks, 2000u);
}

TEST(HapticLoop, GivesNoForceBeforeItIsArmedAndNoneOnceDisarmed) {
  FloorLoop loop;
  for (int i = 0; i < 100; ++i) {
    loop.tick();
    ASSERT_EQ(loop.force(), DVec3(0.0));
  }
  EXPECT_GT(loop.status().wanted.force.y, 0.5) << "but it knows what it would";
  loop.tick_until_armed();
  EXPECT_GT(loop.force().y, 0.1);
  loop.guarded().disarm();
  loop.tick();
  EXPECT_EQ(loop.force(), DVec3(0.0));
  EXPECT_EQ(loop.status().safety.state, SafetyState::kDisarmed);
}

TEST(HapticLoop, LetsGoOfADeviceThatIsDetached) {
  FloorLoop loop;
  loop.tick_until_armed();
  const auto device = loop.loop().detach();
  EXPECT_EQ(device.get(), &loop.guarded());
  EXPECT_EQ(loop.force(), DVec3(0.0));
  EXPECT_EQ(loop.status().applied.force, DVec3(0.0));
  loop.tick();
  EXPECT_EQ(loop.status().ticks, 2000u);
  // Back after a pause of any length: force fades in anew.
  EXPECT_TRUE(loop.loop().attach(device, {}));
  loop.tick();
  EXPECT_EQ(loop.status().safety.state, SafetyState::kRamping);
  EXPECT_LT(loop.force().y, 1e-3);
}

TEST(HapticLoop, DoesNotShareADevice) {
  FloorLoop loop;
  Scene other_scene(SceneOptions{.cutoff = 0.01});
  HapticLoop other(other_scene);
  const auto device = loop.loop().detach();
  ASSERT_TRUE(other.attach(device, {}));
  EXPECT_FALSE(loop.loop().attach(device, {}));
  EXPECT_EQ(loop.loop().device(), nullptr);
  EXPECT_TRUE(other.attach(device, {})) << "only its mapping changes";
  other.detach();
  EXPECT_TRUE(loop.loop().attach(device, {}));
}

TEST(HapticLoop, GoesOnWithoutATool) {
  FloorLoop loop;
  loop.tick_until_armed();
  loop.scene().remove(loop.scene().tool());
  for (int i = 0; i < 100; ++i) loop.tick();
  EXPECT_EQ(loop.force(), DVec3(0.0));
  EXPECT_EQ(loop.status().safety.state, SafetyState::kArmed);
  loop.scene().add({.kind = BodyKind::kTool, .model = asset_model("box"), .pose = {}});
  for (int i = 0; i < 1000; ++i) loop.tick();
  EXPECT_GT(loop.force().y, 0.1);
}

TEST(HapticLoop, AllocatesNothingOnceItHasMetItsScene) {
  FloorLoop loop;
  loop.tick_until_armed();
  HandOrder order;
  ScriptParameters tap;
  tap.period = 0.2;
  order.motion = std::make_shared<ScriptedMotion>(HandScript::kTap, tap);
  loop.device().phantom().set_motion(order.motion);
  for (int i = 0; i < 1000; ++i) loop.tick();
  for (int round = 0; round < 3; ++round) {
    loop.guarded().arm();
    loop.guarded().set_settings(loop.guarded().own_settings());
    const std::uint64_t before = allocation_count();
    for (int i = 0; i < 1000; ++i) loop.tick();
    EXPECT_EQ(allocation_count(), before);
  }
}

TEST(HapticLoop, RepeatsItselfBitByBit) {
  FloorLoop one, other;
  one.guarded().arm();
  other.guarded().arm();
  for (int i = 0; i < 2000; ++i) {
    one.tick();
    other.tick();
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(one.force()[axis]),
                std::bit_cast<std::uint64_t>(other.force()[axis]))
          << i;
    }
  }
}

// A Touch has no torque: what is wanted of it is dropped, and told.
TEST(HapticLoop, TellsOfTorqueThatADeviceCannotGive) {
  Scene scene(SceneOptions{.cutoff = 0.01, .stiffness = 100.0});
  Pose below;
  below.translation = {0.04, -0.105, 0.0};
  scene.add({.model = asset_model("box"), .pose = below});
  scene.add({.kind = BodyKind::kTool, .model = asset_model("box"), .pose = {}});
  const auto device = std::make_shared<GuardedDevice>(std::make_unique<SimulatedPhantom>(touch_spec()));
  HapticLoop loop(scene);
  ASSERT_TRUE(loop.attach(device, {}));
  device->arm();
  for (int i = 0; i < 1500; ++i) loop.tick(1e-3);
  const DeviceStatus status = device->status();
  EXPECT_GT(std::abs(status.wanted.torque.z), 1e-3);
  EXPECT_EQ(status.applied.torque, DVec3(0.0));
  EXPECT_GT(status.applied.force.y, 0.0);
  EXPECT_TRUE(status.unactuated);
  EXPECT_EQ(status.safety.ticks_of(Limiter::kTorqueClamp), 0u) << "dropped, not clamped";
}

}  // namespace
}  // namespace palpate::test
