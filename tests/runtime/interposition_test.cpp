// The servo path under replaced functions of the C library: in a tick it may neither allocate, lock, wait nor
// use files.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "engine/device/simulated/simulated_phantom.h"
#include "engine/runtime/scene_threads.h"
#include "tests/runtime/forbidden_calls.h"
#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

using test::ForbiddenCalls;

constexpr ServoOptions kServo{.rate_hz = 1000.0, .priority = ServoOptions::kNoPriority};

// Compilers leave out what is allocated for nothing.
void* volatile kept = nullptr;

class GuardedScene : public ServoTask {
 public:
  explicit GuardedScene(LiveScene& scene) : scene_(scene) {}

  void tick(double dt) noexcept override {
    const ForbiddenCalls guard;
    scene_.tick(dt);
  }

 private:
  LiveScene& scene_;
};

// Does one forbidden thing in its third tick.
class Culprit : public ServoTask {
 public:
  void tick(double) noexcept override {
    const ForbiddenCalls guard;
    if (++ticks_ == 3) kept = std::malloc(8);
  }

 private:
  int ticks_ = 0;
};

TEST(ForbiddenCallsDeathTest, AreSeen) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  std::mutex mutex;
  EXPECT_DEATH(
      {
        const ForbiddenCalls guard;
        kept = std::malloc(8);
      },
      "forbidden call: malloc");
  EXPECT_DEATH(
      {
        const ForbiddenCalls guard;
        kept = new int(8);
      },
      "forbidden call: malloc");
  EXPECT_DEATH(
      {
        kept = std::malloc(8);
        const ForbiddenCalls guard;
        std::free(kept);
      },
      "forbidden call: free");
  EXPECT_DEATH(
      {
        const ForbiddenCalls guard;
        mutex.lock();
      },
      "forbidden call: pthread_mutex_lock");
  EXPECT_DEATH(
      {
        const ForbiddenCalls guard;
        kept = std::fopen("/dev/null", "r");
      },
      "forbidden call: fopen");
  EXPECT_DEATH(
      {
        const ForbiddenCalls guard;
        std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      },
      "forbidden call: (clock_)?nanosleep");
}

TEST(ForbiddenCallsDeathTest, AreSeenOnAServoThread) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(
      {
        Culprit culprit;
        ServoThread servo;
        static_cast<void>(servo.start(culprit, kServo));
        std::this_thread::sleep_for(std::chrono::seconds(10));
      },
      "forbidden call: malloc");
}

void wait_for_ticks(SceneThreads& threads, std::uint64_t count) {
  const std::uint64_t until = threads.state().statistics.ticks + count;
  while (threads.state().statistics.ticks < until)
    std::this_thread::sleep_for(std::chrono::microseconds(200));
}

void wait_for_preparations(LiveScene& scene, std::uint64_t count) {
  while (scene.counts().preparations < count) std::this_thread::sleep_for(std::chrono::microseconds(200));
}

BodyId add(LiveScene& scene, const std::shared_ptr<const Model>& model, BodyKind kind, const Pose& pose) {
  BodyOptions options;
  options.kind = kind;
  options.model = model;
  options.pose = pose;
  const Result<BodyId> id = scene.add(std::move(options));
  EXPECT_TRUE(id.ok());
  return id.ok() ? id.value() : 0;
}

class ServoPath : public testing::TestWithParam<SearchMode> {};

// A hand slides over one body while others come near, are added where it is, and are removed, all of it
// recorded.
TEST_P(ServoPath, NeitherAllocatesNorLocksNorBlocks) {
  constexpr std::uint64_t kSeed = 21;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  const auto body = asset_model("organic_2200"), tool = asset_model("torus"), box = asset_model("box", 0.3);
  const double cutoff = 0.02 * body->bounds().diagonal();
  Random random(kSeed);
  const std::vector<Pose> motion =
      sliding_motion(*body, *tool, cutoff, 0.3 * body->bounds().diagonal(), 200, random);
  LiveScene scene({.cutoff = cutoff, .mode = GetParam()});
  add(scene, body, BodyKind::kStatic, {});
  const BodyId tool_id = add(scene, tool, BodyKind::kTool, motion[0]);
  GuardedScene guarded(scene);
  SceneThreads threads(scene);
  const std::filesystem::path trace =
      std::filesystem::temp_directory_path() / ("palpate_servo_path_" + std::to_string(::getpid()));
  ASSERT_TRUE(scene.record(trace.string(), {}).ok());
  ASSERT_TRUE(threads.start(kServo, guarded));

  std::size_t sets = 0, overlaps = 0;
  BodyId last = 0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    ASSERT_TRUE(scene.set_pose(tool_id, motion[i]));
    if (i % 5 == 0) {
      EXPECT_EQ(scene.remove(last), last != 0);
      Pose beside = motion[i];
      beside.translation += (tool->radius() + 0.5 * box->radius()) * random.direction();
      const std::uint64_t ready = scene.counts().preparations;
      last = add(scene, box, BodyKind::kMoving, beside);
      wait_for_preparations(scene, ready + 1);
    }
    if (i % 11 == 0) scene.set_cutoff(cutoff * random.uniform(0.7, 1.3));
    if (i % 13 == 0) scene.set_stiffness(random.uniform(100.0, 900.0));
    wait_for_ticks(threads, 1);
    scene.visit_newer([&](const Contacts& contacts) {
      sets += contacts.set_count;
      overlaps += contacts.overlaps.size();
    });
  }
  const LiveCounts counts = scene.counts();
  Recording recording;
  EXPECT_TRUE(scene.stop_recording(recording).ok());
  std::filesystem::remove(trace);
  EXPECT_GE(recording.counts.ticks + recording.counts.lost, motion.size());
  EXPECT_GT(recording.counts.ticks, 0u);
  threads.stop();
  std::printf("%zu sets, %zu overlaps, %llu pairs made ready, %llu ticks waited, %llu were cut\n", sets,
              overlaps, static_cast<unsigned long long>(counts.preparations),
              static_cast<unsigned long long>(counts.waiting_ticks),
              static_cast<unsigned long long>(counts.cut_ticks));
  EXPECT_GT(sets, motion.size() / 2);
  EXPECT_GT(overlaps, 0u);
  EXPECT_GE(counts.preparations, motion.size() / 5);
}

// The tool goes from hand to hand, and its device is told what to do meanwhile.
TEST(ServoPathInHand, NeitherAllocatesNorLocksNorBlocks) {
  const auto box = asset_model("box");
  LiveScene scene({.cutoff = 0.01, .stiffness = 150.0});
  Pose below;
  below.translation.y = -0.105;
  add(scene, box, BodyKind::kStatic, below);
  const BodyId tool = add(scene, box, BodyKind::kTool, {});
  GuardedScene guarded(scene);
  SceneThreads threads(scene);
  ASSERT_TRUE(threads.start(kServo, guarded));
  std::uint64_t pushed = 0;
  for (int i = 0; i < 8; ++i) {
    auto device = std::make_shared<GuardedDevice>(std::make_unique<SimulatedPhantom>(premium6dof_spec()));
    HandOrder order;
    order.impedance = impedance_of(Grip::kLight);
    order.place = true;
    device->order_hand(std::move(order));
    ASSERT_TRUE(scene.set_device(device, {}));
    device->arm();
    wait_for_ticks(threads, 150);
    pushed += device->status().wanted.force.y > 0.0;
    EXPECT_TRUE(scene.pose_of(tool).has_value());
    if (i % 2 == 1) {
      EXPECT_TRUE(scene.set_device(nullptr, {}).ok());
    }
  }
  threads.stop();
  EXPECT_GT(pushed, 4u);
}

// Modes are switched, the tool is exchanged, and the front outgrows its room.
TEST(ServoPathBorders, NeitherAllocateNorLockNorBlock) {
  const auto body = asset_model("spring_23k"), tool = asset_model("teapot_5600");
  const double cutoff = 0.05 * body->bounds().diagonal();
  Random random(3);
  const Pose pose = place_near(*body, *tool, 0.1 * cutoff, random);
  LiveScene scene({.cutoff = cutoff});
  const BodyId body_id = add(scene, body, BodyKind::kMoving, {});
  BodyId tool_id = add(scene, tool, BodyKind::kTool, pose);
  GuardedScene guarded(scene);
  SceneThreads threads(scene);
  ASSERT_TRUE(threads.start(kServo, guarded));
  constexpr SearchMode kModes[] = {SearchMode::kDescent, SearchMode::kCertified, SearchMode::kGlobal,
                                   SearchMode::kCertified};
  for (int i = 0; i < 40; ++i) {
    scene.set_mode(kModes[i % 4]);
    scene.set_law(i % 3 == 0 ? ForceLaw::kSprings : ForceLaw::kSmooth);
    scene.set_cutoff(i % 8 == 3 ? 6.0 * cutoff : cutoff);
    if (i % 10 == 9) {
      ASSERT_TRUE(scene.remove(tool_id));
      tool_id = add(scene, tool, BodyKind::kTool, pose);
    }
    Pose moved;
    moved.translation = 0.1 * cutoff * random.direction();
    ASSERT_TRUE(scene.set_pose(body_id, moved));
    wait_for_ticks(threads, 5);
  }
  EXPECT_GT(scene.counts().cut_ticks, 0u) << "the front was given up at least once";
}

INSTANTIATE_TEST_SUITE_P(Modes, ServoPath,
                         testing::Values(SearchMode::kGlobal, SearchMode::kDescent, SearchMode::kCertified),
                         [](const testing::TestParamInfo<SearchMode>& info) {
                           return std::string(info.param == SearchMode::kGlobal    ? "Global"
                                              : info.param == SearchMode::kDescent ? "Descent"
                                                                                   : "Certified");
                         });

}  // namespace
}  // namespace palpate
