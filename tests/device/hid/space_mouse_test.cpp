#include "tests/device/hid/hid_bench.h"
#include "tests/device/hid/mock_space_mouse.h"

namespace palpate::test {
namespace {

constexpr double kTick = 1e-3;

class HidSpaceMouse : public HidBench {
 protected:
  void SetUp() override {
    mock_ = std::make_shared<MockSpaceMouse>();
    number_ = bus_.plug(mock_);
    device_ = std::make_unique<GuardedDevice>(open("256f:c635"));
    ASSERT_TRUE(wait_until([&] { return mock_->is_open(); }));
  }

  DeviceState tick() {
    const DeviceState state = device_->read();
    device_->write({}, true, kTick);
    return state;
  }

  // Until the device's own thread has brought it.
  template <class Condition>
  bool tick_until(Condition&& condition) {
    return wait_until([&] { return condition(tick()); });
  }

  std::shared_ptr<MockSpaceMouse> mock_;
  std::unique_ptr<GuardedDevice> device_;
};

const Report kPushRight{1, 0x5E, 0x01, 0, 0, 0, 0};
const Report kTurn{2, 0, 0, 0, 0, 0x5E, 0x01};

TEST_F(HidSpaceMouse, IsAPoseSourceWithoutForce) {
  EXPECT_EQ(device_->info().capabilities.sensed, kAllDegrees);
  EXPECT_EQ(device_->info().capabilities.actuated, 0);
  EXPECT_EQ(device_->info().limits.max_force, 0.0);
  EXPECT_EQ(device_->info().identity.uri, "hid:256f:c635");
}

TEST_F(HidSpaceMouse, MovesWhilePushedAndStopsWhenItFallsSilent) {
  mock_->send(kPushRight);
  ASSERT_TRUE(tick_until([](const DeviceState& s) { return s.tool.linear_velocity.x > 0.149; }));
  const double from = tick().tool.position.x;
  double moved = 0.0;
  int ticks = 0;
  for (; ticks < 1000 && tick().tool.linear_velocity.x > 0.0; ++ticks) moved = tick().tool.position.x - from;
  EXPECT_LE(ticks, 60) << "a tenth of a second, two ticks a turn";
  EXPECT_LT(moved, 0.02);
  const double place = tick().tool.position.x;
  for (int i = 0; i < 100; ++i) tick();
  EXPECT_EQ(tick().tool.position.x, place);
}

TEST_F(HidSpaceMouse, DownAtTheDeviceIsDownInTheBaseFrame) {
  mock_->send(Report{1, 0, 0, 0x5E, 0x01, 0x5E, 0x01});  // towards the user, and down
  ASSERT_TRUE(tick_until([](const DeviceState& s) {
    return s.tool.linear_velocity.y < -0.149 && s.tool.linear_velocity.z > 0.149 &&
           s.tool.linear_velocity.x == 0.0;
  }));
  mock_->send(kTurn);
  ASSERT_TRUE(tick_until([](const DeviceState& s) { return s.tool.angular_velocity.y < -1.49; }));
}

TEST_F(HidSpaceMouse, ButtonsAreHeldWithoutEnd) {
  mock_->send(Report{3, 1, 0});
  ASSERT_TRUE(tick_until([](const DeviceState& s) { return s.buttons == 1; }));
  for (int i = 0; i < 300; ++i) ASSERT_EQ(tick().buttons, 1u);
  mock_->send(Report{3, 0, 0});
  EXPECT_TRUE(tick_until([](const DeviceState& s) { return s.buttons == 0; }));
}

TEST_F(HidSpaceMouse, PulledOutItStandsStillAndPluggedInAgainItGoesOn) {
  mock_->send(kPushRight);
  ASSERT_TRUE(tick_until([](const DeviceState& s) { return s.tool.position.x > 0.001; }));
  bus_.unplug(number_);
  ASSERT_TRUE(tick_until([](const DeviceState& s) { return s.condition == DeviceCondition::kLost; }));
  tick();
  const DVec3 place = tick().tool.position;
  EXPECT_EQ(tick().tool.linear_velocity, DVec3(0.0));
  mock_ = std::make_shared<MockSpaceMouse>();
  bus_.plug(mock_);
  ASSERT_TRUE(tick_until([](const DeviceState& s) { return s.condition == DeviceCondition::kReady; }));
  EXPECT_EQ(tick().tool.position, place);
  ASSERT_TRUE(wait_until([&] { return mock_->is_open(); }));
  mock_->send(kPushRight);
  EXPECT_TRUE(tick_until([&](const DeviceState& s) { return s.tool.position.x > place.x; }));
}

}  // namespace
}  // namespace palpate::test
