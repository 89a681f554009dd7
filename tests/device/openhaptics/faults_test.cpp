// Every planted fault ends in its status and in no force, and is recovered from.
#include <functional>
#include <ostream>

#include <gtest/gtest.h>

#include "tests/device/openhaptics/phantom_loop.h"

namespace palpate::test {
namespace {

struct PlantedFault {
  const char* name;
  std::function<void(StandInFaults&)> plant;
  DeviceCondition condition;
  SafetyState state = SafetyState::kFault;
  Limiter limiter = Limiter::kDevice;
};

void PrintTo(const PlantedFault& fault, std::ostream* out) {
  *out << fault.name;
}

class Faults : public testing::TestWithParam<PlantedFault> {};

// Frames without force, or motors without frames or amplifiers.
bool is_at_rest(const StandInRecord& now, const StandInRecord& before) {
  return now.pushes == before.pushes;
}

TEST_P(Faults, EndTheForceAndPass) {
  const PlantedFault& fault = GetParam();
  StandInLibrary library;
  PhantomLoop loop(library);
  loop.want({{1.5, 1.0, 0.0}, {0.0, 0.02, 0.0}});
  ASSERT_TRUE(loop.engage());
  library.plant(fault.plant);
  library.tick(10);
  const StandInRecord within = library.record();
  EXPECT_EQ(loop.status().safety.state, fault.state);
  EXPECT_EQ(loop.status().state.condition, fault.condition);
  EXPECT_EQ(loop.status().applied.force, DVec3(0.0));
  if (fault.state == SafetyState::kFault) {
    EXPECT_GT(loop.status().safety.ticks_of(fault.limiter), 0u);
  }
  library.tick(1000);
  EXPECT_TRUE(is_at_rest(library.record(), within)) << "no force while it lasts";
  EXPECT_EQ(loop.status().state.condition, fault.condition);
  library.plant([](StandInFaults& faults) { faults = {}; });
  EXPECT_TRUE(loop.until([&] { return loop.status().safety.state == SafetyState::kArmed; }));
  library.tick(10);
  EXPECT_EQ(loop.status().state.condition, DeviceCondition::kReady);
  EXPECT_EQ(library.record().force[0], 1.5);
  EXPECT_TRUE(library.record().output);
  EXPECT_FALSE(is_at_rest(library.record(), within));
}

INSTANTIATE_TEST_SUITE_P(
    OpenHaptics, Faults,
    testing::Values(PlantedFault{"unplugged", [](StandInFaults& faults) { faults.unplugged = true; },
                                 DeviceCondition::kLost},
                    PlantedFault{"comm_error", [](StandInFaults& faults) { faults.error = 0x0302; },
                                 DeviceCondition::kLost},
                    PlantedFault{"device_fault", [](StandInFaults& faults) { faults.error = 0x0300; },
                                 DeviceCondition::kLost},
                    PlantedFault{"max_force", [](StandInFaults& faults) { faults.error = 0x0201; },
                                 DeviceCondition::kExceededForce},
                    PlantedFault{"impulse", [](StandInFaults& faults) { faults.error = 0x0202; },
                                 DeviceCondition::kExceededForce},
                    PlantedFault{"max_velocity", [](StandInFaults& faults) { faults.error = 0x0203; },
                                 DeviceCondition::kExceededVelocity},
                    PlantedFault{"warm_motors", [](StandInFaults& faults) { faults.error = 0x0200; },
                                 DeviceCondition::kWarmMotors},
                    PlantedFault{"unknown_error", [](StandInFaults& faults) { faults.error = 0x0777; },
                                 DeviceCondition::kFailed},
                    PlantedFault{"no_frame", [](StandInFaults& faults) { faults.swallows_frames = true; },
                                 DeviceCondition::kFailed},
                    PlantedFault{"nan_pose", [](StandInFaults& faults) { faults.sends_nan = true; },
                                 DeviceCondition::kReady, SafetyState::kFault, Limiter::kNonFinitePose},
                    PlantedFault{"jumping_pose", [](StandInFaults& faults) { faults.strides = true; },
                                 DeviceCondition::kReady, SafetyState::kFault, Limiter::kPoseJump},
                    PlantedFault{"needs_calibration",
                                 [](StandInFaults& faults) { faults.calibration = 0x5002; },
                                 DeviceCondition::kNeedsCalibration, SafetyState::kDisarmed}),
    [](const auto& test) { return test.param.name; });

// After a single one, too, the amplifiers are switched off and on, and force fades in.
TEST(OpenHapticsFaults, ASingleExceededForceTogglesTheAmplifiers) {
  StandInLibrary library;
  PhantomLoop loop(library);
  loop.want({{1.0, 0.0, 0.0}, DVec3(0.0)});
  ASSERT_TRUE(loop.engage());
  const StandInRecord before = library.record();
  library.plant([](StandInFaults& faults) { faults.error_once = 0x0201; });
  library.tick(2);
  EXPECT_FALSE(library.record().output);
  EXPECT_EQ(sent_force(library.record()), 0.0);
  library.tick(400);
  EXPECT_FALSE(library.record().output);
  ASSERT_TRUE(loop.until([&] { return library.record().output; }));
  EXPECT_EQ(library.record().output_changes, before.output_changes + 2);
  ASSERT_TRUE(loop.until([&] { return library.record().force[0] > 0.0; }));
  EXPECT_LT(library.record().force[0], 0.01) << "it fades in";
}

TEST(OpenHapticsFaults, WarmMotorsRestUntilTheyAreCool) {
  StandInLibrary library;
  PhantomLoop loop(library);
  loop.want({{1.0, 0.0, 0.0}, DVec3(0.0)});
  ASSERT_TRUE(loop.engage());
  library.plant([](StandInFaults& faults) { faults.temperature = 0.9; });
  library.tick(100);
  EXPECT_EQ(loop.status().state.temperature, 0.9) << "said before it is too late";
  EXPECT_EQ(loop.status().state.condition, DeviceCondition::kReady);
  library.plant([](StandInFaults& faults) { faults.temperature = 0.97; });
  library.tick(100);
  EXPECT_EQ(loop.status().state.condition, DeviceCondition::kWarmMotors);
  library.plant([](StandInFaults& faults) { faults.temperature = 0.9; });
  library.tick(3000);
  EXPECT_EQ(loop.status().state.condition, DeviceCondition::kWarmMotors);
  EXPECT_EQ(sent_force(library.record()), 0.0);
  library.plant([](StandInFaults& faults) { faults.temperature = 0.5; });
  EXPECT_TRUE(loop.until([&] { return library.record().force[0] == 1.0; }));
}

TEST(OpenHapticsFaults, AreOfOneDevice) {
  StandInLibrary library;
  PhantomLoop premium(library), touch(library, "Left");
  premium.want({{1.0, 0.0, 0.0}, DVec3(0.0)});
  touch.want({{0.0, 2.0, 0.0}, DVec3(0.0)});
  ASSERT_TRUE(premium.engage());
  ASSERT_TRUE(touch.engage());
  library.plant([](StandInFaults& faults) { faults.error = 0x0201; });
  library.tick(200);
  EXPECT_EQ(premium.status().state.condition, DeviceCondition::kExceededForce);
  EXPECT_EQ(touch.status().state.condition, DeviceCondition::kReady);
  EXPECT_EQ(library.record(0).force[0], 0.0);
  EXPECT_EQ(library.record(1).force[1], 2.0);
}

// The library has one stack for the errors of all.
TEST(OpenHapticsFaults, ThatLieAmongThoseOfAnotherAreTold) {
  StandInLibrary library;
  PhantomLoop premium(library), touch(library, "Left");
  for (const int source : {0, 1}) {
    library.tick(1000);
    library.plant([](StandInFaults& faults) { faults.stray_error = 0x0203; }, source);
    library.tick(2);
    PhantomLoop& meant = source == 0 ? touch : premium;
    PhantomLoop& other = source == 0 ? premium : touch;
    EXPECT_EQ(meant.status().state.condition, DeviceCondition::kExceededVelocity);
    EXPECT_EQ(other.status().state.condition, DeviceCondition::kReady);
  }
}

TEST(OpenHapticsFaults, ASampleWithAnErrorIsNone) {
  StandInLibrary library;
  PhantomLoop loop(library);
  library.tick(10);
  const std::uint64_t before = loop.status().state.sequence;
  library.plant([](StandInFaults& faults) { faults.error_once = 0x0203; });
  library.tick();
  EXPECT_EQ(loop.status().state.sequence, before);
  library.tick();
  EXPECT_EQ(loop.status().state.sequence, before + 1);
}

// The other one rests while the lost one is let go, and goes on while it is looked for.
TEST(OpenHapticsFaults, OneLostDeviceLeavesTheOtherInUse) {
  StandInLibrary library;
  PhantomLoop premium(library), touch(library, "Left");
  touch.want({{0.0, 2.0, 0.0}, DVec3(0.0)});
  ASSERT_TRUE(touch.engage());
  library.plant([](StandInFaults& faults) { faults.unplugged = true; });
  ASSERT_TRUE(premium.until([&] { return !library.record(0).open; })) << "its handle is given back";
  ASSERT_TRUE(touch.until([&] { return library.record(1).force[1] == 2.0; }));
  EXPECT_EQ(premium.status().state.condition, DeviceCondition::kLost);
  library.plant([](StandInFaults& faults) { faults.unplugged = false; });
  ASSERT_TRUE(premium.until([&] { return premium.status().state.condition == DeviceCondition::kReady; }));
  EXPECT_TRUE(library.record(0).open);
  EXPECT_TRUE(touch.until([&] { return library.record(1).force[1] == 2.0; }));
}

TEST(OpenHapticsFaults, AreExplained) {
  StandInLibrary library;
  PhantomLoop loop(library);
  library.plant([](StandInFaults& faults) { faults.swallows_frames = true; });
  library.tick(5);
  EXPECT_NE(loop.device().advice(DeviceCondition::kFailed).find("stand-in frame error"), std::string::npos);
  EXPECT_NE(loop.device().advice(DeviceCondition::kLost).find("cable"), std::string::npos);
}

}  // namespace
}  // namespace palpate::test
