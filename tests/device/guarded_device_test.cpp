#include "engine/device/guarded_device.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "engine/device/simulated/recorded_motion.h"
#include "engine/device/simulated/simulated_phantom.h"
#include "tests/support/allocation_count.h"

namespace palpate {
namespace {

constexpr double kTick = 1e-3;

std::unique_ptr<GuardedDevice> premium() {
  return std::make_unique<GuardedDevice>(std::make_unique<SimulatedPhantom>(premium6dof_spec()));
}

void tick(GuardedDevice& device, const DeviceWrench& wanted = {}) {
  device.read();
  device.write(wanted, true, kTick);
}

std::shared_ptr<const HandMotion> hold_at(const DVec3& place) {
  return RecordedMotion::from({{0.0, {place, DQuat(1.0, 0.0, 0.0, 0.0)}}}).value();
}

// Knows whether it was destroyed.
class WatchedMotion final : public HandMotion {
 public:
  explicit WatchedMotion(bool& alive) : alive_(alive) { alive_ = true; }
  ~WatchedMotion() override { alive_ = false; }
  HandPose at(double) const override { return {}; }

 private:
  bool& alive_;
};

TEST(GuardedDevice, ShowsItsFirstSampleBeforeAnyTick) {
  const auto device = premium();
  const DeviceStatus status = device->status();
  EXPECT_TRUE(status.state.calibrated);
  EXPECT_EQ(status.ticks, 0u);
  EXPECT_EQ(status.safety.state, SafetyState::kDisarmed);
}

TEST(GuardedDevice, TakesOrdersWithTheNextTick) {
  const auto device = premium();
  HandOrder order;
  order.motion = hold_at({0.01, 0.02, 0.03});
  order.place = true;
  order.buttons = 1;
  ASSERT_TRUE(device->order_hand(order));
  device->arm();
  EXPECT_EQ(device->simulated()->true_motion().position, DVec3(0.0));
  tick(*device);
  EXPECT_EQ(device->simulated()->true_motion().position, DVec3(0.01, 0.02, 0.03));
  tick(*device);
  EXPECT_EQ(device->status().safety.state, SafetyState::kRamping);
  EXPECT_EQ(device->status().state.buttons, 1u);
}

TEST(GuardedDevice, HoldsToTighterSettings) {
  const auto device = premium();
  SafetySettings weak = device->own_settings();
  weak.max_force = 0.5;
  device->set_settings(weak);
  device->arm();
  for (int i = 0; i < 1500; ++i) tick(*device, {DVec3(0.0, 5.0, 0.0), DVec3(0.0)});
  EXPECT_DOUBLE_EQ(device->status().applied.force.y, 0.5);
  EXPECT_EQ(device->status().wanted.force.y, 5.0);
  EXPECT_TRUE(device->status().safety.is_acting(Limiter::kForceClamp));
}

TEST(GuardedDevice, MayBeClaimedByOneAtATime) {
  const auto device = premium();
  EXPECT_TRUE(device->claim());
  EXPECT_FALSE(device->claim());
  device->give_up();
  EXPECT_TRUE(device->claim());
}

// What a tick takes out of use is destroyed by whoever orders next, not by the tick.
TEST(GuardedDevice, DestroysNothingInATick) {
  const auto device = premium();
  bool first = false, second = false;
  HandOrder order;
  order.motion = std::make_shared<WatchedMotion>(first);
  device->order_hand(std::move(order));
  tick(*device);
  order = {};
  order.motion = std::make_shared<WatchedMotion>(second);
  device->order_hand(std::move(order));
  const std::uint64_t before = test::allocation_count();
  tick(*device);
  EXPECT_EQ(test::allocation_count(), before);
  EXPECT_TRUE(first && second);
  device->arm();
  EXPECT_FALSE(first);
  EXPECT_TRUE(second);
}

TEST(GuardedDevice, DestroysOrdersThatNoTickTook) {
  bool alive = false;
  {
    const auto device = premium();
    HandOrder order;
    order.motion = std::make_shared<WatchedMotion>(alive);
    device->order_hand(std::move(order));
    EXPECT_TRUE(alive);
  }
  EXPECT_FALSE(alive);
}

// Orders and questions from several threads while one ticks: what is seen is of one tick and never goes back.
TEST(GuardedDevice, IsOrderedAndAskedWhileItTicks) {
  constexpr int kTicks = 3000, kOrders = 300, kThreads = 3;
  const auto device = premium();
  std::vector<std::thread> others;
  for (int thread = 0; thread < kThreads; ++thread) {
    others.emplace_back([&device] {
      std::uint64_t seen = 0;
      for (int i = 0; i < kOrders; ++i) {
        HandOrder order;
        order.motion = hold_at({1e-5 * i, 0.0, 0.0});
        device->order_hand(std::move(order));
        i % 2 ? device->arm() : device->disarm();
        const DeviceStatus status = device->status();
        EXPECT_GE(status.ticks, seen);
        EXPECT_EQ(status.wanted.force.y, static_cast<double>(status.ticks)) << "two ticks were mixed";
        seen = status.ticks;
      }
    });
  }
  for (int i = 1; i <= kTicks; ++i) tick(*device, {DVec3(0.0, i, 0.0), DVec3(0.0)});
  for (std::thread& other : others) other.join();
  EXPECT_EQ(device->status().ticks, static_cast<std::uint64_t>(kTicks));
}

}  // namespace
}  // namespace palpate
