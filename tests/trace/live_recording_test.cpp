// A servo records without waiting, and what it recorded can be replayed in steps.
#include <chrono>
#include <cstdio>
#include <thread>

#include "tests/trace/traces.h"

namespace palpate::test {
namespace {

void start(plp_scene scene, double rate) {
  plp_servo_options options;
  plp_servo_options_init(&options, sizeof options);
  options.rate = rate;
  options.priority = -1;
  ASSERT_EQ(plp_scene_start(scene, &options), PLP_OK) << plp_last_error();
}

plp_servo_state servo_of(plp_scene scene) {
  plp_servo_state state;
  plp_servo_state_init(&state, sizeof state);
  EXPECT_EQ(plp_scene_get_servo(scene, &state), PLP_OK);
  return state;
}

void wait_for_tick(plp_scene scene) {
  const std::uint64_t until = servo_of(scene).ticks + 1;
  while (servo_of(scene).ticks < until) std::this_thread::sleep_for(std::chrono::microseconds(100));
}

struct LiveManner {
  plp_mode mode;
  plp_law law;
};

class LiveRecording : public testing::TestWithParam<LiveManner> {
 protected:
  TestModel ring_{torus(1.0, 0.35, 24, 12)};
  TestModel box_{box(0.2f, 0.2f, 0.2f)};
};

// All that the servo met is ready from its first tick on, so that no tick waits.
TEST_P(LiveRecording, ReplaysInStepsToTheSameWrench) {
  TraceFile file;
  plp_scene_options options = TestScene::options_with(0.3);
  options.mode = GetParam().mode;
  options.law = GetParam().law;
  std::uint64_t ticks = 0;
  {
    TestScene scene(options);
    scene.add(ring_.handle, PLP_BODY_STATIC, at(0, 0, 0));
    Wander wander(0.35, 3);
    const plp_body tool = scene.add(box_.handle, PLP_BODY_TOOL, wander.next());
    ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK);
    start(scene.handle, 1000.0);
    for (int i = 0; i < 200; ++i) {
      const plp_pose pose = wander.next();
      ASSERT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      wait_for_tick(scene.handle);
    }
    ASSERT_EQ(plp_scene_stop(scene.handle), PLP_OK);
    ticks = servo_of(scene.handle).ticks;
    const plp_recording recording = stop_recording(scene.handle);
    EXPECT_EQ(recording.ticks + recording.lost, ticks);
  }

  const TestTrace trace(file);
  EXPECT_EQ(trace.info().ticks + trace.info().lost, ticks);
  ASSERT_GE(trace.info().ticks, 200u);
  TestScene scene(trace.options());
  const plp_body ring = scene.add(ring_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body tool = scene.add(box_.handle, PLP_BODY_TOOL, at(0, 0, 0));
  std::uint64_t compared = 0, pushed = 0;
  for (std::uint64_t i = 0; i < trace.info().ticks; ++i) {
    const plp_trace_tick tick = trace.read(i);
    ASSERT_EQ(plp_trace_place(trace.handle, i, trace.body(0).body, scene.handle, ring), PLP_OK);
    ASSERT_EQ(plp_trace_place(trace.handle, i, trace.body(1).body, scene.handle, tool), PLP_OK);
    const plp_contacts again = scene.step();
    // History is in walls alone, which a tick that is flagged may have brought about.
    if (((tick.status | again.status) & ~std::uint32_t{PLP_STATUS_BY_DESCENT}) != 0) continue;
    ++compared;
    pushed += tick.wrench.force[0] != 0.0;
    EXPECT_EQ(std::memcmp(&tick.wrench, &again.wrench, sizeof again.wrench), 0) << "tick " << i;
  }
  std::printf("%llu ticks, %llu compared, %llu with a push\n", static_cast<unsigned long long>(ticks),
              static_cast<unsigned long long>(compared), static_cast<unsigned long long>(pushed));
  EXPECT_GT(compared, ticks / 4);
  EXPECT_GT(pushed, 20u);
}

INSTANTIATE_TEST_SUITE_P(Manners, LiveRecording,
                         testing::Values(LiveManner{PLP_MODE_GLOBAL, PLP_LAW_SPRINGS},
                                         LiveManner{PLP_MODE_GLOBAL, PLP_LAW_SMOOTH},
                                         LiveManner{PLP_MODE_CERTIFIED, PLP_LAW_SPRINGS},
                                         LiveManner{PLP_MODE_CERTIFIED, PLP_LAW_SMOOTH}));

class LiveSession : public testing::Test {
 protected:
  TestModel ring_{torus(1.0, 0.35, 24, 12)};
  TestModel box_{box(0.2f, 0.2f, 0.2f)};
};

// Bodies come and go, settings change, and the recording begins and ends while the servo runs.
TEST_F(LiveSession, MayBeginAndEndWhileBodiesComeAndGo) {
  TestScene scene(0.3);
  scene.add(ring_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  Wander wander(0.35, 9);
  const plp_body tool = scene.add(box_.handle, PLP_BODY_TOOL, wander.next());
  start(scene.handle, 2000.0);
  for (int round = 0; round < 4; ++round) {
    TraceFile file;
    ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK) << plp_last_error();
    std::vector<plp_body> guests;
    for (int i = 0; i < 60; ++i) {
      const plp_pose pose = wander.next();
      ASSERT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      if (i % 3 == 0) guests.push_back(scene.add(box_.handle, PLP_BODY_MOVING, at(0.0, 2.0 + i, 0.0)));
      if (i % 3 == 2) {
        wait_for_tick(scene.handle);
        wait_for_tick(scene.handle);
        ASSERT_EQ(plp_scene_remove_body(scene.handle, guests.back()), PLP_OK);
      }
      if (i % 7 == 0) {
        ASSERT_EQ(plp_scene_set_stiffness(scene.handle, 100.0 + i), PLP_OK);
      }
      wait_for_tick(scene.handle);
    }
    wait_for_tick(scene.handle);
    const plp_recording recording = stop_recording(scene.handle);
    const TestTrace trace(file);
    EXPECT_EQ(trace.info().complete, 1);
    EXPECT_EQ(trace.info().ticks, recording.ticks);
    ASSERT_EQ(trace.info().bodies, 2 + guests.size());
    for (std::uint64_t i = 2; i < trace.info().bodies; ++i) {
      const plp_trace_body guest = trace.body(i);
      EXPECT_EQ(guest.body, guests[i - 2]);
      EXPECT_LT(guest.first_tick, guest.end_tick);
      EXPECT_LT(guest.end_tick, trace.info().ticks);
    }
    double clock = 0.0;
    for (std::uint64_t i = 0; i < trace.info().ticks; ++i) {
      const plp_trace_tick tick = trace.read(i);
      EXPECT_GT(tick.clock, clock);
      EXPECT_EQ(tick.time_step, 0.0005);
      clock = tick.clock;
    }
    EXPECT_EQ(trace.read(trace.info().ticks - 1).stiffness, 156.0);
  }
}

}  // namespace
}  // namespace palpate::test
