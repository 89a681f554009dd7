// What a recording keeps of a session, and how it fails.
#include <filesystem>
#include <utility>

#include "tests/trace/traces.h"

namespace palpate::test {
namespace {

class RecordingTest : public testing::Test {
 protected:
  TestModel box_{box(0.5f, 0.5f, 0.5f)};
};

TEST_F(RecordingTest, KeepsWhatChangesBetweenSteps) {
  TraceFile file;
  TestScene scene(0.2);
  const plp_body still = scene.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body tool = scene.add(box_.handle, PLP_BODY_TOOL, at(1.1, 0, 0));
  scene.step();
  ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK) << plp_last_error();
  scene.step();  // tick 0, step 2
  const plp_body guest = scene.add(box_.handle, PLP_BODY_MOVING, at(0, 3, 0));
  ASSERT_EQ(plp_scene_set_stiffness(scene.handle, 77.0), PLP_OK);
  scene.step();  // tick 1
  const plp_pose moved = at(0.0, 4.0, 0.25);
  ASSERT_EQ(plp_scene_set_pose(scene.handle, guest, &moved), PLP_OK);
  scene.step();  // tick 2
  ASSERT_EQ(plp_scene_remove_body(scene.handle, guest), PLP_OK);
  ASSERT_EQ(plp_scene_set_mode(scene.handle, PLP_MODE_GLOBAL), PLP_OK);
  ASSERT_EQ(plp_scene_set_law(scene.handle, PLP_LAW_SMOOTH), PLP_OK);
  scene.step();  // tick 3
  ASSERT_EQ(plp_scene_remove_body(scene.handle, tool), PLP_OK);
  scene.step();  // tick 4
  EXPECT_EQ(stop_recording(scene.handle).ticks, 5u);

  const TestTrace trace(file);
  ASSERT_EQ(trace.info().ticks, 5u);
  ASSERT_EQ(trace.info().bodies, 3u);
  EXPECT_EQ(trace.body(0).body, still);
  EXPECT_EQ(trace.body(1).kind, PLP_BODY_TOOL);
  EXPECT_STREQ(trace.body(1).model_name, "triangles");
  EXPECT_EQ(trace.body(1).model_triangles, 12u);
  EXPECT_EQ(trace.body(2).body, guest);
  EXPECT_EQ(trace.body(2).first_tick, 1u);
  EXPECT_EQ(trace.body(2).end_tick, 3u);
  EXPECT_EQ(trace.body(1).end_tick, 4u);

  plp_trace_tick tick = trace.read(0);
  EXPECT_EQ(tick.step, 2u);
  ASSERT_EQ(tick.move_count, 1u);
  EXPECT_EQ(tick.moves[0].body, still);
  EXPECT_EQ(tick.tool, tool);
  EXPECT_EQ(tick.tool_pose.position[0], 1.1);
  EXPECT_EQ(tick.stiffness, 1000.0);
  tick = trace.read(1);
  ASSERT_EQ(tick.move_count, 1u);
  EXPECT_EQ(tick.moves[0].body, guest);
  EXPECT_EQ(tick.stiffness, 77.0);
  tick = trace.read(2);
  ASSERT_EQ(tick.move_count, 1u);
  EXPECT_EQ(tick.moves[0].pose.position[2], 0.25);
  EXPECT_EQ(tick.stiffness, 77.0);
  EXPECT_EQ(tick.mode, PLP_MODE_CERTIFIED);
  tick = trace.read(3);
  EXPECT_EQ(tick.move_count, 0u);
  ASSERT_EQ(tick.removed_count, 1u);
  EXPECT_EQ(tick.removed[0], guest);
  EXPECT_EQ(tick.mode, PLP_MODE_GLOBAL);
  EXPECT_EQ(tick.law, PLP_LAW_SMOOTH);
  tick = trace.read(4);
  EXPECT_EQ(tick.tool, 0u);
  EXPECT_EQ(tick.set_count, 0u);

  plp_pose found;
  ASSERT_EQ(plp_trace_place(trace.handle, 2, guest, scene.handle, still), PLP_OK);
  ASSERT_EQ(plp_scene_get_pose(scene.handle, still, &found), PLP_OK);
  EXPECT_EQ(found.position[1], 4.0);
  EXPECT_EQ(plp_trace_place(trace.handle, 3, guest, scene.handle, still), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_trace_place(trace.handle, 0, guest, scene.handle, still), PLP_ERROR_INVALID_ARGUMENT);
}

// Far more cells than the ring has.
TEST_F(RecordingTest, LosesNoStepOfACaller) {
  TraceFile file;
  const TestModel ring(torus(1.0, 0.35, 24, 12));
  TestScene scene(0.3);
  scene.add(ring.handle, PLP_BODY_STATIC, at(0, 0, 0));
  const TestModel small(box(0.2f, 0.2f, 0.2f));
  const plp_body tool = scene.add(small.handle, PLP_BODY_TOOL, at(0, 0, 0));
  ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK);
  constexpr int kSteps = 12'000;
  Wander wander(0.35, 5);
  std::size_t cells = 0;
  for (int i = 0; i < kSteps; ++i) {
    const plp_pose pose = wander.next();
    ASSERT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
    cells += 1 + scene.step().lmd_count;
  }
  EXPECT_GT(cells, 32'768u) << "more than the ring takes";
  const plp_recording recording = stop_recording(scene.handle);
  EXPECT_EQ(recording.ticks, std::uint64_t{kSteps});
  EXPECT_EQ(recording.lost, 0u);
  EXPECT_EQ(TestTrace(file).info().ticks, std::uint64_t{kSteps});
}

TEST_F(RecordingTest, IsRefusedWhereItCannotBe) {
  TraceFile file;
  TestScene scene(0.2);
  EXPECT_EQ(plp_scene_record(scene.handle, nullptr), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_record(scene.handle, ""), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_record(nullptr, file.path()), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_record(scene.handle, "/nowhere/at/all"), PLP_ERROR_FILE_NOT_FOUND);
  EXPECT_EQ(plp_scene_record(scene.handle, "/"), PLP_ERROR_FILE_WRITE);
  EXPECT_EQ(plp_scene_record(scene.handle, "/dev/full"), PLP_ERROR_FILE_WRITE);
  EXPECT_NE(std::string(plp_last_error()).find("/dev/full"), std::string::npos) << plp_last_error();
  EXPECT_EQ(plp_scene_stop_recording(scene.handle, nullptr), PLP_ERROR_WRONG_STATE);
  ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK);
  EXPECT_EQ(plp_scene_record(scene.handle, file.path()), PLP_ERROR_WRONG_STATE);
  plp_recording recording;
  plp_recording_init(&recording, sizeof recording);
  EXPECT_EQ(plp_scene_get_recording(scene.handle, &recording), PLP_OK);
  EXPECT_EQ(recording.running, 1);
  EXPECT_EQ(plp_scene_stop_recording(scene.handle, nullptr), PLP_OK);
  EXPECT_EQ(TestTrace(file).info().ticks, 0u);
}

TEST_F(RecordingTest, AFullDiskKeepsTheFileThatItHas) {
  TraceFile file;
  const TraceFile none;
  file.write("what was here before");
  TestScene scene(0.2);
  {
    const FileSizeLimit limit(30);
    for (const TraceFile* const refused : {&std::as_const(file), &none}) {
      EXPECT_EQ(plp_scene_record(scene.handle, refused->path()), PLP_ERROR_FILE_WRITE);
      EXPECT_NE(std::string(plp_last_error()).find(refused->path()), std::string::npos) << plp_last_error();
    }
  }
  EXPECT_EQ(file.bytes(), "what was here before");
  EXPECT_FALSE(std::filesystem::exists(none.path()));
}

// A longer file than a whole trace leaves nothing of itself.
TEST_F(RecordingTest, WhatWasThereIsGone) {
  TraceFile file;
  file.write(std::string(1'000'000, 'x'));
  TestScene scene(0.2);
  ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK);
  scene.step();
  const plp_recording recording = stop_recording(scene.handle);
  EXPECT_EQ(file.bytes().size(), recording.bytes);
  EXPECT_EQ(TestTrace(file).info().complete, 1);
}

// A disk that fills up later. The limit on the size of files makes write() fail with EFBIG.
TEST_F(RecordingTest, AFullDiskIsToldAtTheEndAndWhatIsWholeCanBeRead) {
  TraceFile file;
  TestScene scene(0.2);
  scene.add(box_.handle, PLP_BODY_STATIC, at(0, 0, 0));
  scene.add(box_.handle, PLP_BODY_TOOL, at(1.1, 0, 0));
  const FileSizeLimit limit(600'000);
  ASSERT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK);
  constexpr std::uint64_t kSteps = 4'000;
  for (std::uint64_t i = 0; i < kSteps; ++i) ASSERT_EQ(plp_scene_step(scene.handle), PLP_OK);
  plp_recording recording;
  plp_recording_init(&recording, sizeof recording);
  EXPECT_EQ(plp_scene_stop_recording(scene.handle, &recording), PLP_ERROR_FILE_WRITE);
  EXPECT_NE(std::string(plp_last_error()).find(file.path()), std::string::npos) << plp_last_error();
  EXPECT_EQ(recording.ticks + recording.lost, kSteps);
  EXPECT_GT(recording.ticks, 0u);
  EXPECT_GT(recording.lost, 0u);
  const TestTrace trace(file);
  EXPECT_EQ(trace.info().complete, 0);
  EXPECT_GE(trace.info().ticks, recording.ticks);
  trace.read(trace.info().ticks - 1);
  EXPECT_EQ(plp_scene_step(scene.handle), PLP_OK);
}

}  // namespace
}  // namespace palpate::test
