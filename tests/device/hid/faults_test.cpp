#include <algorithm>

#include "tests/device/hid/hid_bench.h"
#include "tests/device/hid/servo_loop.h"

namespace palpate::test {
namespace {

constexpr int kWatchdog = 10;  // samples, and ticks
constexpr int kSlack = 2;      // one for the sample that is on its way, one for the tick that is

// A haptic device that pushes with one newton, in a servo; then something goes wrong.
class HidFaults : public HidBench {
 protected:
  void open_and_arm(const hid_device::Features& features = {}) {
    mock_ = plug_ohhp("SN42", features);
    guarded_ = std::make_unique<GuardedDevice>(open("1209:0001"));
    guarded_->arm();
    servo_ = std::make_unique<ServoLoop>(*guarded_);
  }

  void expect_pushing() {
    ASSERT_TRUE(servo_->wait_until_armed());
    const auto mock = mock_;
    ASSERT_TRUE(wait_until([&] { return mock->log().back().force > 0.99; }));
  }

  bool wait_for(DeviceCondition condition) {
    return servo_->wait_for([=](const ServoLoop::Tick& tick) { return tick.state.condition == condition; }) >=
           0;
  }

  bool wait_for(SafetyState state) {
    return servo_->wait_for([=](const ServoLoop::Tick& tick) { return tick.safety.state == state; }) >= 0;
  }

  // From so many samples after `step` on, the motors gave nothing.
  void expect_let_go(const MockOhhp::Step* first, const MockOhhp::Step* last) {
    EXPECT_GT(last - first, kWatchdog + kSlack);
    for (first += kWatchdog + kSlack; first < last; ++first) ASSERT_EQ(first->force, 0.0);
  }

  void expect_let_go_since(std::size_t step) {
    ASSERT_TRUE(wait_until([&] { return mock_->steps() > step + 100; }));
    const auto log = mock_->log();
    expect_let_go(log.data() + step, log.data() + step + 100);
  }

  // What must hold of any run: no force on an old sample, or in a fault; sequence and time never turn back.
  void expect_safe() {
    const auto ticks = servo_->ticks();
    int age = 0;
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      const DeviceState& now = ticks[i].state;
      age = now.sequence == ticks[i - 1].state.sequence ? age + 1 : 0;
      ASSERT_GE(now.sequence, ticks[i - 1].state.sequence);
      ASSERT_GE(now.time, ticks[i - 1].state.time);
      const bool must_let_go = age > kWatchdog || is_fault(now.condition);
      ASSERT_TRUE(!must_let_go || ticks[i].applied.force == DVec3(0.0)) << "tick " << i;
    }
  }

  void TearDown() override {
    if (servo_) expect_safe();
    servo_.reset();
    guarded_.reset();
  }

  std::shared_ptr<MockOhhp> mock_;
  std::unique_ptr<GuardedDevice> guarded_;
  std::unique_ptr<ServoLoop> servo_;
};

TEST_F(HidFaults, DamagedReportsEndInNoForceAndAreCountedAsLost) {
  open_and_arm();
  expect_pushing();
  mock_->damage(30);
  ASSERT_TRUE(servo_->wait_for([](const auto& tick) { return tick.safety.is_acting(Limiter::kStalePose); }) >=
              0);
  expect_pushing();
  EXPECT_EQ(guarded_->status().state.lost, 30u);
}

TEST_F(HidFaults, AFewLostReportsAreCountedAndNoMore) {
  open_and_arm();
  expect_pushing();
  mock_->swallow(5);
  ASSERT_TRUE(servo_->wait_for([](const auto& tick) { return tick.state.lost == 5; }) >= 0);
  const auto from = mock_->steps();
  ASSERT_TRUE(wait_until([&] { return mock_->steps() > from + 200; }));
  EXPECT_EQ(guarded_->status().state.lost, 5u);
}

TEST_F(HidFaults, ADeviceThatFallsSilentIsLostUntilItSpeaks) {
  open_and_arm();
  expect_pushing();
  mock_->pause(true);
  ASSERT_TRUE(wait_for(SafetyState::kFault));
  ASSERT_TRUE(wait_for(DeviceCondition::kLost));
  mock_->pause(false);
  expect_pushing();
  EXPECT_GT(guarded_->status().state.lost, 90u);
}

TEST_F(HidFaults, TheSequenceWrapsWithoutLoss) {
  mock_ = plug_ohhp();
  mock_->change([](hid_device::HapticDevice& device) { device.set_sequence(65'000); });
  guarded_ = std::make_unique<GuardedDevice>(open("1209:0001"));
  guarded_->arm();
  servo_ = std::make_unique<ServoLoop>(*guarded_);
  ASSERT_TRUE(servo_->wait_for([](const auto& tick) { return tick.state.sequence > 800; }) >= 0);
  EXPECT_LT(mock_->log().back().sequence, 60'000);
  expect_pushing();
  EXPECT_EQ(guarded_->status().state.lost, 0u);
}

TEST_F(HidFaults, ADeviceThatBeginsAnewIsFollowed) {
  open_and_arm();
  expect_pushing();
  mock_->change([](hid_device::HapticDevice& device) { device.set_sequence(0); });
  expect_pushing();
  EXPECT_EQ(guarded_->status().state.lost, 0u);
}

TEST_F(HidFaults, PulledOutItLetsGoAndPluggedInAgainItIsTakenUp) {
  open_and_arm();
  expect_pushing();
  bus_.unplug(number_);
  const std::size_t step = mock_->steps();
  ASSERT_TRUE(wait_for(DeviceCondition::kLost));
  expect_let_go_since(step);
  EXPECT_EQ(guarded_->status().state.condition, DeviceCondition::kLost);
  EXPECT_EQ(guarded_->status().safety.state, SafetyState::kFault);
  const auto stranger = plug_ohhp("OTHER");
  mock_ = plug_ohhp("SN42");
  expect_pushing();
  EXPECT_EQ(guarded_->status().state.condition, DeviceCondition::kReady);
  EXPECT_FALSE(stranger->is_open());
}

TEST_F(HidFaults, AnotherDeviceInItsPlaceIsNotTakenUp) {
  open_and_arm();
  expect_pushing();
  bus_.unplug(number_);
  ASSERT_TRUE(wait_for(DeviceCondition::kLost));
  hid_device::Features stronger;
  stronger.max_force = 20.0;
  const auto impostor = plug_ohhp("SN42", stronger);
  ASSERT_TRUE(wait_until([&] { return impostor->watchdog_ms() != 0; }));  // it was asked
  bus_.unplug(number_);
  EXPECT_EQ(guarded_->status().state.condition, DeviceCondition::kLost);
  mock_ = plug_ohhp("SN42");
  expect_pushing();
}

// Longer than what it takes at once.
TEST_F(HidFaults, AReaderThatStallsGoesOnWithTheNewestSample) {
  constexpr std::size_t kMissed = 300;
  open_and_arm();
  expect_pushing();
  mock_->hold_readers(true);
  ASSERT_TRUE(wait_for(SafetyState::kFault));
  const std::size_t began = mock_->steps();
  const std::uint64_t before = guarded_->status().state.sequence;
  ASSERT_TRUE(wait_until([&] { return mock_->steps() > began + kMissed; }));
  mock_->hold_readers(false);
  const long resumed = servo_->wait_for([=](const auto& tick) { return tick.state.sequence != before; });
  ASSERT_GE(resumed, 0);
  EXPECT_GE(servo_->ticks()[static_cast<std::size_t>(resumed)].state.sequence, before + 50);
  EXPECT_EQ(guarded_->status().state.lost, 0u);
  expect_pushing();
}

TEST_F(HidFaults, ATransferThatDoesNotEndIsADeviceThatIsLost) {
  open_and_arm();
  expect_pushing();
  mock_->stop_taking(true);
  const std::size_t step = mock_->steps();
  ASSERT_TRUE(wait_for(DeviceCondition::kLost));
  ASSERT_TRUE(wait_for(SafetyState::kFault));
  expect_let_go_since(step);
  mock_->stop_taking(false);
  expect_pushing();
}

TEST_F(HidFaults, AServoThatHangsLetsGo) {
  mock_ = plug_ohhp();
  guarded_ = std::make_unique<GuardedDevice>(open("1209:0001"));
  guarded_->arm();
  const auto pushing = [&] {
    guarded_->read();
    guarded_->write({DVec3(0.0, 1.0, 0.0), DVec3(0.0)}, true, 1e-3);
    return mock_->log().back().force > 0.99;
  };
  ASSERT_TRUE(wait_until(pushing));
  expect_let_go_since(mock_->steps());
  ASSERT_TRUE(wait_until([&] { return !mock_->log().back().armed; }));
  ASSERT_TRUE(wait_until(pushing)) << "it is taken up again";
}

TEST_F(HidFaults, ItsDeadManSwitchDisarms) {
  hid_device::Features features;
  features.traits = 1;
  open_and_arm(features);
  expect_pushing();
  mock_->change([](hid_device::HapticDevice& device) { device.hold_dead_man(false); });
  ASSERT_TRUE(wait_for(SafetyState::kDisarmed));
  ASSERT_TRUE(wait_until([&] { return !mock_->log().back().armed; })) << "its amplifiers are off, too";
  mock_->change([](hid_device::HapticDevice& device) { device.hold_dead_man(true); });
  expect_pushing();
}

TEST_F(HidFaults, ItsEmergencyStopIsAFaultUntilItIsReleased) {
  open_and_arm();
  expect_pushing();
  mock_->change([](hid_device::HapticDevice& device) { device.press_emergency_stop(true); });
  ASSERT_TRUE(wait_for(DeviceCondition::kFailed));
  EXPECT_NE(guarded_->advice(DeviceCondition::kFailed).find("emergency stop"), std::string::npos);
  mock_->change([](hid_device::HapticDevice& device) { device.press_emergency_stop(false); });
  expect_pushing();
}

TEST_F(HidFaults, HotMotorsRest) {
  open_and_arm();
  expect_pushing();
  mock_->change([](hid_device::HapticDevice& device) { device.set_temperature(255); });
  ASSERT_TRUE(wait_for(DeviceCondition::kWarmMotors));
  EXPECT_EQ(guarded_->status().state.temperature, 1.0);
  mock_->change([](hid_device::HapticDevice& device) { device.set_temperature(100); });
  expect_pushing();
}

TEST_F(HidFaults, WithoutCalibrationThereIsNoForce) {
  hid_device::Features features;
  features.traits = 2;
  open_and_arm(features);
  ASSERT_TRUE(wait_for(DeviceCondition::kNeedsCalibration));
  ASSERT_TRUE(servo_->wait_for([](const auto& tick) { return tick.state.sequence > 200; }) >= 0);
  for (const auto& tick : servo_->ticks()) ASSERT_EQ(tick.applied.force, DVec3(0.0));
  EXPECT_TRUE(guarded_->calibrate());
  expect_pushing();
}

TEST_F(HidFaults, ClosedItIsDisarmed) {
  open_and_arm();
  expect_pushing();
  servo_.reset();
  guarded_.reset();
  const std::size_t step = mock_->steps();
  ASSERT_TRUE(wait_until([&] { return mock_->steps() > step + 1; }));
  EXPECT_FALSE(mock_->log().back().armed);
  EXPECT_EQ(mock_->log().back().force, 0.0);
  EXPECT_FALSE(mock_->is_open());
}

TEST_F(HidFaults, TwoDevicesDoNotDisturbEachOther) {
  open_and_arm();
  const int first = number_;
  const auto second = plug_ohhp("B2");
  GuardedDevice other(open("1209:0001:B2"));
  other.arm();
  ServoLoop servo(other, -2.0);
  expect_pushing();
  bus_.unplug(first);
  ASSERT_TRUE(wait_for(DeviceCondition::kLost));
  ASSERT_TRUE(servo.wait_until_armed());
  ASSERT_TRUE(wait_until([&] { return second->log().back().force > 1.99; }));
  EXPECT_EQ(other.status().state.condition, DeviceCondition::kReady);
}

}  // namespace
}  // namespace palpate::test
