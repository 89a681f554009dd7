// Scenes on the scheduler of OpenHaptics, through the C interface.
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tests/capi/devices.h"
#include "tests/device/openhaptics/stand_in_library.h"

namespace palpate::test {
namespace {

using namespace std::chrono_literals;

// Names of this process's threads.
std::set<std::string> thread_names() {
  std::set<std::string> names;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(thread.path() / "comm"), name);
    names.insert(name);
  }
  return names;
}

// Waits in our time, for what other threads do.
template <class Holds>
bool comes_true(Holds holds) {
  for (int i = 0; i < 20'000; ++i) {
    if (holds()) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

// A cube in a light hand above a floor, touching it with the force of a newton or so.
struct CubeOnFloor {
  CubeOnFloor() {
    scene.add(cube.handle, PLP_BODY_STATIC, at(0.0, -0.105, 0.0));
    tool = scene.add(cube.handle, PLP_BODY_TOOL, at(0.0, 0.0, 0.0));
    plp_scene_set_stiffness(scene.handle, 200.0);
    plp_scene_set_stiffness_cap(scene.handle, -1.0);  // what is expected is one spring
  }

  plp_servo_state servo() {
    plp_servo_state state;
    plp_servo_state_init(&state, sizeof state);
    EXPECT_EQ(plp_scene_get_servo(scene.handle, &state), PLP_OK);
    return state;
  }

  plp_wrench computed() {
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    EXPECT_EQ(plp_scene_get_contacts(scene.handle, &contacts), PLP_OK);
    return contacts.wrench;
  }

  TestModel cube{box(0.05f, 0.05f, 0.05f)};
  TestScene scene{0.01};
  plp_body tool = 0;
};

class Riding : public testing::Test {
 protected:
  explicit Riding(bool real_time = false) : library_(real_time) {}

  void attach() {
    ASSERT_EQ(plp_scene_set_device(floor_.scene.handle, device_.handle, nullptr), PLP_OK) << plp_last_error();
  }

  void start() {
    plp_servo_options options;
    plp_servo_options_init(&options, sizeof options);
    options.priority = -1;
    ASSERT_EQ(plp_scene_start(floor_.scene.handle, &options), PLP_OK) << plp_last_error();
  }

  template <class Holds>
  bool until(Holds holds) {
    for (int i = 0; i < 20'000; ++i) {
      if (holds()) return true;
      library_.tick();
    }
    return false;
  }

  void engage() {
    ASSERT_EQ(plp_device_arm(device_.handle), PLP_OK);
    ASSERT_TRUE(until([&] {
      const plp_device_state state = device_.state();
      return state.safety == PLP_SAFETY_ARMED && state.applied.force[1] == state.commanded.force[1];
    }));
  }

  StandInLibrary library_;
  CubeOnFloor floor_;
  TestDevice device_{StandInLibrary::uri("Default Device").c_str()};
};

TEST_F(Riding, TheSchedulerIsTheServo) {
  attach();
  start();
  EXPECT_TRUE(comes_true([] { return thread_names().count("palpate-search") == 1; }));
  EXPECT_EQ(floor_.servo().running, 1);
  EXPECT_EQ(floor_.servo().ticks, 0u);
  library_.tick(100);
  EXPECT_EQ(floor_.servo().ticks, 100u);
  EXPECT_EQ(device_.state().ticks, 100u);
  EXPECT_EQ(floor_.servo().wanted_rate, 1000.0);
  EXPECT_EQ(thread_names().count("palpate-servo"), 0u);
  EXPECT_EQ(plp_scene_step(floor_.scene.handle), PLP_ERROR_WRONG_STATE);
  ASSERT_EQ(plp_scene_stop(floor_.scene.handle), PLP_OK);
  library_.tick(10);
  EXPECT_EQ(floor_.servo().running, 0);
  EXPECT_EQ(floor_.servo().ticks, 100u);
  EXPECT_EQ(plp_scene_step(floor_.scene.handle), PLP_OK);
}

// The force on the motors is that of the sample of the same tick, which a second scene computes from the
// pose.
TEST_F(Riding, TheHandFeelsWhatTheSceneComputes) {
  attach();
  start();
  engage();
  CubeOnFloor oracle;
  for (int i = 0; i < 50; ++i) {
    library_.tick();
    const plp_device_state state = device_.state();
    const plp_wrench computed = floor_.computed();
    ASSERT_EQ(plp_scene_set_pose(oracle.scene.handle, oracle.tool, &state.pose), PLP_OK);
    const plp_wrench expected = oracle.scene.step().wrench;
    EXPECT_GT(expected.force[1], 0.5);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_NEAR(computed.force[axis], expected.force[axis], 1e-9);
      ASSERT_EQ(state.applied.force[axis], computed.force[axis]);
      ASSERT_EQ(library_.record().force[axis], state.applied.force[axis]);
      ASSERT_EQ(library_.record().torque[axis], 1e3 * state.applied.torque[axis]);
    }
  }
  EXPECT_GT(library_.record().handle[1], 1e-3) << "the floor lifts the hand";
  EXPECT_EQ(library_.record().sets_outside, 0u);
}

TEST_F(Riding, StoppingTheSceneEndsTheForce) {
  attach();
  start();
  engage();
  ASSERT_EQ(plp_scene_stop(floor_.scene.handle), PLP_OK);
  library_.tick(11);
  EXPECT_EQ(sent_force(library_.record()), 0.0);
}

TEST_F(Riding, ACallersStepIsOneTickLate) {
  attach();
  ASSERT_EQ(plp_device_arm(device_.handle), PLP_OK);
  for (int i = 0; i < 1500; ++i) {
    floor_.scene.step();
    const plp_device_state state = device_.state();
    library_.tick();
    ASSERT_EQ(library_.record().force[1], state.applied.force[1]);
  }
  EXPECT_GT(library_.record().force[1], 0.5);
}

// From a thread of the library to the scheduler, and back.
TEST_F(Riding, AServoMovesToItsDevicesLoop) {
  start();
  ASSERT_TRUE(comes_true([&] { return floor_.servo().ticks > 5; })) << "it ticks by itself";
  EXPECT_TRUE(comes_true([] { return thread_names().count("palpate-servo") == 1; }));
  attach();
  EXPECT_TRUE(comes_true([] { return thread_names().count("palpate-servo") == 0; }));
  const std::uint64_t ticks = floor_.servo().ticks;
  library_.tick(50);
  EXPECT_EQ(floor_.servo().ticks, ticks + 50);
  engage();
  ASSERT_EQ(plp_scene_set_device(floor_.scene.handle, nullptr, nullptr), PLP_OK);
  EXPECT_EQ(floor_.servo().running, 1);
  ASSERT_TRUE(comes_true([&] { return floor_.servo().ticks > 5; }));
  library_.tick(2);
  EXPECT_EQ(sent_force(library_.record()), 0.0) << "the hand was let go";
  const TestDevice simulated;
  EXPECT_EQ(plp_scene_set_device(floor_.scene.handle, simulated.handle, nullptr), PLP_OK);
  EXPECT_TRUE(comes_true([&] { return simulated.state().ticks > 5; }));
}

TEST_F(Riding, ADeviceIsKeptByTheSceneThatRidesOnIt) {
  attach();
  start();
  ASSERT_EQ(plp_device_retain(device_.handle), PLP_OK);
  ASSERT_EQ(plp_device_release(device_.handle), PLP_OK);
  library_.tick(10);
  EXPECT_TRUE(library_.record().open);
  EXPECT_EQ(plp_shutdown_all(), PLP_OK);
  library_.tick(10);
  EXPECT_EQ(floor_.servo().ticks, 10u);
}

TEST_F(Riding, SeveralScenesRideOnOneScheduler) {
  const TestDevice touch(StandInLibrary::uri("Left").c_str());
  CubeOnFloor other;
  ASSERT_EQ(plp_scene_set_device(other.scene.handle, touch.handle, nullptr), PLP_OK);
  attach();
  start();
  ASSERT_EQ(plp_scene_start(other.scene.handle, nullptr), PLP_OK);
  ASSERT_EQ(plp_device_arm(touch.handle), PLP_OK);
  engage();
  library_.tick(10);
  EXPECT_EQ(floor_.servo().ticks, other.servo().ticks);
  EXPECT_GT(library_.record(0).force[1], 0.5);
  EXPECT_GT(library_.record(1).force[1], 0.5);
  EXPECT_EQ(library_.record(1).torques_refused, 0u);
}

TEST_F(Riding, TheDeviceSaysWhatItsUserCanDo) {
  EXPECT_STREQ(device_.info().status, "ready");
  library_.plant([](StandInFaults& faults) { faults.calibration = 0x5002; });
  library_.tick();
  EXPECT_EQ(device_.info().condition, PLP_CONDITION_NEEDS_CALIBRATION);
  EXPECT_NE(std::strstr(device_.info().status, "right angles"), nullptr);
  EXPECT_EQ(device_.state().calibrated, 0) << "before any scene has it";
  EXPECT_EQ(plp_device_calibrate(device_.handle), PLP_OK);
  library_.tick(2);
  EXPECT_EQ(device_.state().calibrated, 1);
  EXPECT_EQ(device_.info().condition, PLP_CONDITION_READY);
  library_.plant([](StandInFaults& faults) { faults.temperature = 0.5; });
  library_.tick(100);
  EXPECT_EQ(device_.state().temperature, 0.5);
}

TEST(RidingList, TellsWhatIsMissing) {
  setenv("PALPATE_OPENHAPTICS_LIBRARY", "/nonexistent/libHD.so", 1);
  std::vector<plp_device_info> infos(16);
  plp_device_info_init(&infos[0], sizeof infos[0]);
  std::size_t count = 0;
  ASSERT_EQ(plp_device_list(infos.data(), infos.size(), &count), PLP_OK);
  unsetenv("PALPATE_OPENHAPTICS_LIBRARY");
  infos.resize(std::min(infos.size(), count));
  const auto listed = std::find_if(infos.begin(), infos.end(), [](const plp_device_info& info) {
    return std::strcmp(info.uri, "openhaptics:Default Device") == 0;
  });
  ASSERT_NE(listed, infos.end());
  EXPECT_EQ(listed->condition, PLP_CONDITION_NO_LIBRARY);
  EXPECT_NE(std::strstr(listed->status, "install OpenHaptics 3.4"), nullptr) << listed->status;
}

class RidingInRealTime : public Riding {
 protected:
  RidingInRealTime() : Riding(true) {}

  bool comes_to(int condition, int safety) {
    return comes_true([&] {
      const plp_device_state state = device_.state();
      return state.condition == condition && state.safety == safety;
    });
  }
};

// Pulled out and put back while bodies come and go; nothing is started anew.
TEST_F(RidingInRealTime, ADeviceIsPulledOutAndPutBack) {
  attach();
  start();
  ASSERT_EQ(plp_device_arm(device_.handle), PLP_OK);
  ASSERT_TRUE(comes_to(PLP_CONDITION_READY, PLP_SAFETY_ARMED));
  for (int round = 0; round < 2; ++round) {
    library_.plant([](StandInFaults& faults) { faults.unplugged = true; });
    ASSERT_TRUE(comes_to(PLP_CONDITION_LOST, PLP_SAFETY_FAULT));
    EXPECT_EQ(device_.state().applied.force[1], 0.0);
    const plp_body passing = floor_.scene.add(floor_.cube.handle, PLP_BODY_STATIC, at(0.0, 0.2, 0.0));
    ASSERT_TRUE(comes_true([&] { return !library_.record().open; }));
    library_.plant([](StandInFaults& faults) { faults.unplugged = false; });
    ASSERT_TRUE(comes_to(PLP_CONDITION_READY, PLP_SAFETY_ARMED));
    EXPECT_TRUE(comes_true([&] { return library_.record().force[1] > 0.5; }));
    EXPECT_EQ(plp_scene_remove_body(floor_.scene.handle, passing), PLP_OK);
  }
  EXPECT_EQ(floor_.servo().running, 1);
  EXPECT_EQ(library_.record().sets_outside, 0u);
  EXPECT_LE(library_.record().most_force, 8.5);
}

// The scheduler rests while another device is opened and closed: force ends before, and fades in after.
TEST_F(RidingInRealTime, OpeningAnotherDeviceLetsForceFadeInAnew) {
  attach();
  start();
  ASSERT_EQ(plp_device_arm(device_.handle), PLP_OK);
  ASSERT_TRUE(comes_to(PLP_CONDITION_READY, PLP_SAFETY_ARMED));
  const std::uint64_t ramped = device_.state().limiter_ticks[PLP_LIMITER_RAMP];
  const std::uint64_t changes = library_.record().output_changes;
  const int starts = library_.starts();
  { const TestDevice touch(StandInLibrary::uri("Left").c_str()); }
  EXPECT_EQ(library_.starts(), starts + 2);
  ASSERT_TRUE(comes_true([&] { return device_.state().limiter_ticks[PLP_LIMITER_RAMP] > ramped + 100; }));
  ASSERT_TRUE(comes_to(PLP_CONDITION_READY, PLP_SAFETY_ARMED));
  EXPECT_GE(library_.record().output_changes, changes + 2) << "amplifiers too are switched off and on";
}

// Neither waits for ever nor calls into a library that has ended.
TEST(RidingDeathTest, AProcessMayEndWithADeviceInUse) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        StandInLibrary library(true);
        CubeOnFloor floor;
        plp_device device = nullptr;
        plp_device_open(StandInLibrary::uri("Default Device").c_str(), &device);
        plp_scene_set_device(floor.scene.handle, device, nullptr);
        plp_scene_start(floor.scene.handle, nullptr);
        plp_device_arm(device);
        if (!comes_true([&] { return library.record().frames > 20; })) std::exit(1);
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

TEST_F(RidingInRealTime, AStalledSchedulerIsSeen) {
  attach();
  start();
  ASSERT_EQ(plp_device_arm(device_.handle), PLP_OK);
  ASSERT_TRUE(comes_to(PLP_CONDITION_READY, PLP_SAFETY_ARMED));
  library_.stall(true);
  ASSERT_TRUE(comes_to(PLP_CONDITION_LOST, PLP_SAFETY_FAULT));
  EXPECT_EQ(device_.state().applied.force[1], 0.0);
  library_.stall(false);
  EXPECT_TRUE(comes_to(PLP_CONDITION_READY, PLP_SAFETY_ARMED));
}

}  // namespace
}  // namespace palpate::test
