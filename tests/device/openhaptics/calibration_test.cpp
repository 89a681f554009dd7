#include <gtest/gtest.h>

#include "tests/device/openhaptics/phantom_loop.h"

namespace palpate::test {
namespace {

constexpr int kPremium = 0, kTouch = 1;

// Encoders that are reset at the wrong place give wrong poses: a hand has to say when.
TEST(OpenHapticsCalibration, AnEncoderResetWaitsForTheHand) {
  StandInLibrary library;
  PhantomLoop loop(library);
  loop.want({{1.0, 0.0, 0.0}, DVec3(0.0)});
  ASSERT_TRUE(loop.engage());
  library.plant([](StandInFaults& faults) { faults.calibration = 0x5001; });
  library.tick(500);
  EXPECT_EQ(loop.status().state.condition, DeviceCondition::kNeedsCalibration);
  EXPECT_FALSE(loop.status().state.calibrated);
  EXPECT_EQ(loop.status().safety.state, SafetyState::kDisarmed);
  EXPECT_EQ(sent_force(library.record()), 0.0);
  EXPECT_EQ(library.record().updates, 0);
  ASSERT_TRUE(loop.device().calibrate());
  library.tick(5);
  EXPECT_EQ(library.record().updates, 1);
  EXPECT_EQ(library.record().last_style, 1);
  EXPECT_EQ(library.record().updates_with_output, 0);
  EXPECT_TRUE(loop.until([&] { return library.record().force[0] == 1.0; }));
}

// Also where it was calibrated before; the force ends first.
TEST(OpenHapticsCalibration, AnArmedDeviceLetsGoForIt) {
  StandInLibrary library;
  PhantomLoop loop(library);
  loop.want({{1.0, 0.0, 0.0}, DVec3(0.0)});
  ASSERT_TRUE(loop.engage());
  ASSERT_TRUE(loop.device().calibrate());
  library.tick(1);
  EXPECT_EQ(sent_force(library.record()), 0.0);
  EXPECT_EQ(library.record().updates, 1);
  EXPECT_EQ(library.record().updates_with_output, 0);
  EXPECT_TRUE(loop.until([&] { return library.record().force[0] == 1.0; }));
}

TEST(OpenHapticsCalibration, AnInkwellDoesItByItself) {
  StandInLibrary library;
  library.plant([](StandInFaults& faults) { faults.calibration = 0x5002; }, kTouch);
  PhantomLoop loop(library, "Left");
  loop.want({{1.0, 0.0, 0.0}, DVec3(0.0)});
  loop.device().arm();
  library.tick(500);
  EXPECT_EQ(loop.status().state.condition, DeviceCondition::kNeedsCalibration);
  EXPECT_EQ(library.record(kTouch).updates, 0) << "the stylus is not in it yet";
  EXPECT_FALSE(loop.device().calibrate()) << "there is nothing to say";
  EXPECT_NE(loop.device().advice(DeviceCondition::kNeedsCalibration).find("inkwell"), std::string::npos);
  library.plant([](StandInFaults& faults) { faults.calibration = 0x5001; }, kTouch);
  library.tick(5);
  EXPECT_EQ(library.record(kTouch).updates, 1);
  EXPECT_EQ(library.record(kTouch).last_style, 4);
  EXPECT_TRUE(loop.until([&] { return library.record(kTouch).force[0] == 1.0; }));
  EXPECT_EQ(library.record(kTouch).updates_with_output, 0);
}

// An update that does not help is tried again, but not in every tick.
TEST(OpenHapticsCalibration, UpdatesAreSpaced) {
  StandInLibrary library;
  library.plant(
      [](StandInFaults& faults) {
        faults.calibration = 0x5001;
        faults.updating_helps = false;
      },
      kTouch);
  PhantomLoop loop(library, "Left");
  library.tick(1050);
  EXPECT_GE(library.record(kTouch).updates, 5);
  EXPECT_LE(library.record(kTouch).updates, 11);
}

TEST(OpenHapticsCalibration, IsSeenWithoutAScene) {
  StandInLibrary library;
  PhantomLoop loop(library);
  loop.device().servo_host()->put_down();
  loop.device().give_up();
  EXPECT_TRUE(loop.status().state.calibrated);
  library.plant([](StandInFaults& faults) { faults.calibration = 0x5002; });
  library.tick();
  EXPECT_FALSE(loop.status().state.calibrated);
  EXPECT_EQ(loop.status().state.condition, DeviceCondition::kNeedsCalibration);
}

TEST(OpenHapticsButtons, AreBits) {
  StandInLibrary library;
  PhantomLoop premium(library), touch(library, "Left");
  library.plant([](StandInFaults& faults) { faults.buttons = 0b1111; }, kPremium);
  library.plant([](StandInFaults& faults) { faults.buttons = 0b10; }, kTouch);
  library.tick();
  EXPECT_EQ(premium.status().state.buttons, 0b1u) << "it has one";
  EXPECT_EQ(touch.status().state.buttons, 0b110u) << "and out of the inkwell";
}

TEST(OpenHapticsButtons, TheInkwellIsADeadManSwitch) {
  StandInLibrary library;
  PhantomLoop loop(library, "Left");
  SafetySettings settings = loop.device().own_settings();
  settings.dead_man = 0b100;
  loop.device().set_settings(settings);
  loop.want({{1.0, 0.0, 0.0}, DVec3(0.0)});
  ASSERT_TRUE(loop.engage());
  library.plant([](StandInFaults& faults) { faults.in_inkwell = true; }, kTouch);
  library.tick();
  EXPECT_EQ(sent_force(library.record(kTouch)), 0.0);
  EXPECT_EQ(loop.status().safety.state, SafetyState::kDisarmed);
  library.plant([](StandInFaults& faults) { faults.in_inkwell = false; }, kTouch);
  EXPECT_TRUE(loop.until([&] { return library.record(kTouch).force[0] == 1.0; }));
}

}  // namespace
}  // namespace palpate::test
