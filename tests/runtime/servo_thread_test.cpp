#include "engine/runtime/servo_thread.h"

#include <signal.h>

#include <chrono>

#include <gtest/gtest.h>

#include "engine/exchange/counter.h"
#include "engine/runtime/scene_threads.h"
#include "tests/runtime/threads.h"
#include "tests/support/models.h"

namespace palpate {
namespace {

using test::settled_thread_count;
using test::thread_count;

// Counts ticks and stalls once.
class StallingTask : public ServoTask {
 public:
  explicit StallingTask(std::uint64_t stall_at) : stall_at_(stall_at) {}

  void tick(double dt) noexcept override {
    dt_ = dt;
    ticks_.add(1);
    if (ticks_.value() == stall_at_) std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
  std::uint64_t ticks() const { return ticks_.value(); }
  double dt() const { return dt_; }

 private:
  const std::uint64_t stall_at_;
  Counter ticks_;
  double dt_ = 0.0;
};

void wait_for(const StallingTask& task, std::uint64_t ticks) {
  while (task.ticks() < ticks) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(ServoThread, CountsItsTicks) {
  StallingTask task(0);
  ServoThread servo;
  EXPECT_EQ(servo.statistics().ticks, 0u);
  ASSERT_TRUE(servo.start(task, {.rate_hz = 2000.0, .priority = ServoOptions::kNoPriority}));
  wait_for(task, 20);
  servo.stop();
  EXPECT_EQ(task.dt(), 1.0 / 2000.0);
  EXPECT_EQ(servo.statistics().ticks, task.ticks()) << "the last report is of the last tick";
  EXPECT_EQ(servo.statistics().work.count(), task.ticks());
  EXPECT_EQ(servo.statistics().lateness.count(), task.ticks());
  EXPECT_GT(servo.statistics().rate_hz, 0.0);
  EXPECT_EQ(servo.grants().priority, 0);
  EXPECT_EQ(servo.grants().cpu, -1);
}

// 30 periods pass in the stall: they are skipped, not made up for.
TEST(ServoThread, LeavesOutWhatAStallCost) {
  StallingTask task(5);
  ServoThread servo;
  ASSERT_TRUE(servo.start(task, {.rate_hz = 1000.0, .priority = ServoOptions::kNoPriority}));
  wait_for(task, 10);
  servo.stop();
  EXPECT_GE(servo.statistics().missed, 1u);
  EXPECT_GE(servo.statistics().skipped, 29u);
  EXPECT_GE(servo.statistics().work.max_us(), 30'000.0);
}

// A signal to the process is for the program's own threads.
TEST(ServoThread, LeavesSignalsToOthers) {
  class Asking : public ServoTask {
   public:
    void tick(double) noexcept override {
      sigset_t blocked;
      pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
      if (sigismember(&blocked, SIGINT) == 1 && sigismember(&blocked, SIGSEGV) == 0) blocks.add(1);
      ticks.add(1);
    }
    Counter ticks;
    Counter blocks;
  };
  Asking task;
  ServoThread servo;
  ASSERT_TRUE(servo.start(task, {.rate_hz = 1000.0, .priority = ServoOptions::kNoPriority}));
  while (task.ticks.value() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  servo.stop();
  EXPECT_EQ(task.blocks.value(), task.ticks.value());
}

// Whether it is granted depends on the system; it must run either way and say so.
TEST(ServoThread, SaysWhatTheSystemGranted) {
  StallingTask task(0);
  ServoThread servo;
  ASSERT_TRUE(servo.start(task, {.rate_hz = 1000.0, .priority = 7, .cpu = 0}));
  wait_for(task, 3);
  servo.stop();
  EXPECT_TRUE(servo.grants().priority == 7 || servo.grants().priority == 0) << servo.grants().priority;
  EXPECT_TRUE(servo.grants().cpu == 0 || servo.grants().cpu == -1) << servo.grants().cpu;
}

TEST(SceneThreads, LeaveNoThreadBehind) {
  LiveScene scene({.cutoff = 0.01});
  SceneThreads threads(scene);
  ASSERT_TRUE(threads.start({.priority = ServoOptions::kNoPriority}));
  const std::size_t running = thread_count();
  threads.stop();
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(threads.start({.priority = ServoOptions::kNoPriority}));
    EXPECT_TRUE(threads.state().running);
    EXPECT_FALSE(threads.start({})) << "they run already";
    threads.stop();
    threads.stop();
    EXPECT_FALSE(threads.state().running);
  }
  EXPECT_EQ(settled_thread_count(running - 2), running - 2);
}

TEST(SceneThreads, StopAllStopsEveryScene) {
  LiveScene one({.cutoff = 0.01}), other({.cutoff = 0.01});
  SceneThreads threads_of_one(one), threads_of_other(other);
  ASSERT_TRUE(threads_of_one.start({.priority = ServoOptions::kNoPriority}));
  ASSERT_TRUE(threads_of_other.start({.priority = ServoOptions::kNoPriority}));
  const std::size_t running = thread_count();
  SceneThreads::stop_all();
  SceneThreads::stop_all();
  EXPECT_EQ(settled_thread_count(running - 4), running - 4);
  EXPECT_FALSE(threads_of_one.state().running);
  EXPECT_TRUE(one.step()) << "the caller may step it again";
  EXPECT_TRUE(threads_of_one.start({.priority = ServoOptions::kNoPriority}));
}

}  // namespace
}  // namespace palpate
