// The system gives no more threads.
#include <cstdlib>
#include <string>

#include "tests/capi/shapes.h"
#include "tests/device/openhaptics/stand_in_library.h"
#include "tests/fault/refused_calls.h"
#include "tests/trace/traces.h"

namespace palpate::test {
namespace {

class NoThreads : public testing::Test {
 protected:
  NoThreads() {
    scene_.add(ring_.handle, PLP_BODY_STATIC, at(0, 0, 0));
    scene_.add(cube_.handle, PLP_BODY_TOOL, at(1.05, 0, 0));
  }

  static void expect_limit(plp_result result) {
    EXPECT_EQ(result, PLP_ERROR_LIMIT) << plp_last_error();
    EXPECT_NE(std::string(plp_last_error()).find("threads"), std::string::npos) << plp_last_error();
  }

  int running() const {
    plp_servo_state state;
    plp_servo_state_init(&state, sizeof state);
    EXPECT_EQ(plp_scene_get_servo(scene_.handle, &state), PLP_OK);
    return state.running;
  }

  const TestModel ring_{torus(0.5, 0.2, 24, 12)}, cube_{box(0.3f, 0.2f, 0.25f)};
  TestScene scene_{0.1};
};

TEST_F(NoThreads, AServoIsRefusedAndStartsOnceThereAreSome) {
  const std::string before = bits_of(scene_.step());
  for (const int nth : {1, 2}) {
    {
      const NoThreadsFrom refused(nth);
      expect_limit(plp_scene_start(scene_.handle, nullptr));
    }
    EXPECT_EQ(running(), 0);
    plp_contacts after = scene_.step();  // that nothing has moved is no search
    EXPECT_EQ(bits_of(after).substr(0, sizeof after.wrench), before.substr(0, sizeof after.wrench));
  }
  ASSERT_EQ(plp_scene_start(scene_.handle, nullptr), PLP_OK) << plp_last_error();
  EXPECT_EQ(running(), 1);
  EXPECT_EQ(plp_scene_stop(scene_.handle), PLP_OK);
}

TEST_F(NoThreads, ASceneThatStepsWithSeveralIsRefused) {
  plp_scene_options options = TestScene::options_with(0.1);
  options.threads = 4;
  for (const int nth : {1, 2, 3}) {
    const NoThreadsFrom refused(nth);
    plp_scene scene = nullptr;
    expect_limit(plp_scene_create(&options, &scene));
    EXPECT_EQ(scene, nullptr);
  }
  EXPECT_NE(TestScene(options).handle, nullptr);
}

TEST_F(NoThreads, ARecordingIsRefusedAndLeavesTheFileThatIsThere) {
  const TraceFile file, none;
  file.write("what was here before");
  {
    const NoThreadsFrom refused(1);
    expect_limit(plp_scene_record(scene_.handle, file.path()));
    expect_limit(plp_scene_record(scene_.handle, none.path()));
  }
  EXPECT_EQ(file.bytes(), "what was here before");
  EXPECT_FALSE(std::filesystem::exists(none.path()));
  ASSERT_EQ(plp_scene_record(scene_.handle, file.path()), PLP_OK);
  scene_.step();
  stop_recording(scene_.handle);
  EXPECT_EQ(TestTrace(file).info().ticks, 1u);
}

// In a process that has built none yet, and so has no workers.
TEST(NoThreadsDeathTest, AHierarchyIsBuiltWithoutOrRefused) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const TestModel ring(torus(0.5, 0.2, 400, 200));
        plp_result built = PLP_OK;
        {
          const NoThreadsFrom refused(1);
          built = plp_model_prepare(ring.handle);
        }
        const bool told = built == PLP_OK || built == PLP_ERROR_OUT_OF_MEMORY || built == PLP_ERROR_LIMIT;
        std::_Exit(told && plp_model_prepare(ring.handle) == PLP_OK ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST_F(NoThreads, ADeviceThatNeedsOneIsRefused) {
  const StandInLibrary library;
  const std::string uri = StandInLibrary::uri("Default Device");
  plp_device device = nullptr;
  {
    const NoThreadsFrom refused(1);
    expect_limit(plp_device_open(uri.c_str(), &device));
  }
  ASSERT_EQ(plp_device_open(uri.c_str(), &device), PLP_OK) << plp_last_error();
  EXPECT_EQ(plp_device_release(device), PLP_OK);
}

}  // namespace
}  // namespace palpate::test
