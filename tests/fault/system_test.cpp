// What the system does to a process: signals, clocks that jump, forks, an end in the middle.
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "tests/capi/devices.h"
#include "tests/fault/refused_calls.h"
#include "tests/trace/traces.h"

namespace {

bool is_forked = false;

}  // namespace

// Asked by the address sanitizer at the end of a process. A forked child has no thread but the one that
// forked, and what the others held stays locked: there a search for leaks would wait for them for ever.
extern "C" __attribute__((visibility("default"))) int __lsan_is_turned_off() {
  return is_forked;
}

namespace palpate::test {
namespace {

using namespace std::chrono_literals;

// Above a floor that it touches, in a hand.
class Session : public testing::Test {
 protected:
  Session() {
    scene_.add(cube_.handle, PLP_BODY_STATIC, at(0.0, -0.105, 0.0));
    scene_.add(cube_.handle, PLP_BODY_TOOL, at(0.0, 0.0, 0.0));
  }

  void start() { ASSERT_EQ(plp_scene_start(scene_.handle, nullptr), PLP_OK) << plp_last_error(); }

  plp_servo_state servo() const {
    plp_servo_state state;
    plp_servo_state_init(&state, sizeof state);
    EXPECT_EQ(plp_scene_get_servo(scene_.handle, &state), PLP_OK);
    return state;
  }

  bool ticks_on() const {
    const std::uint64_t ticks = servo().ticks;
    return comes_true([&] { return servo().ticks > ticks + 5; });
  }

  // Waits in calls that no signal disturbs.
  template <class Holds>
  static bool comes_true(Holds holds) {
    for (int i = 0; i < 10'000; ++i) {
      if (holds()) return true;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }

  const TestModel cube_{box(0.05f, 0.05f, 0.05f)};
  TestScene scene_{0.01};
};

// A signal every 200 µs, whose handler lets no call begin anew.
class SignalStorm {
 public:
  SignalStorm() {
    count_ = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { ++count_; };
    sigaction(SIGALRM, &action, &before_);
    every(200);
  }
  ~SignalStorm() {
    every(0);
    sigaction(SIGALRM, &before_, nullptr);
  }
  SignalStorm(const SignalStorm&) = delete;
  SignalStorm& operator=(const SignalStorm&) = delete;

  static int count() { return count_; }

 private:
  static void every(suseconds_t us) {
    const itimerval timer{{0, us}, {0, us}};
    setitimer(ITIMER_REAL, &timer, nullptr);
  }

  static inline std::atomic<int> count_ = 0;
  struct sigaction before_ {};
};

TEST_F(Session, ASignalInEveryWaitDisturbsNothing) {
  const TraceFile file;
  const TestDevice device("sim:premium6dof");
  const SignalStorm storm;
  for (int round = 0; round < 5; ++round) {
    ASSERT_EQ(plp_scene_record(scene_.handle, file.path()), PLP_OK) << plp_last_error();
    start();
    ASSERT_EQ(plp_scene_set_device(scene_.handle, device.handle, nullptr), PLP_OK) << plp_last_error();
    EXPECT_TRUE(ticks_on());
    ASSERT_EQ(plp_scene_set_device(scene_.handle, nullptr, nullptr), PLP_OK) << plp_last_error();
    EXPECT_EQ(plp_scene_stop(scene_.handle), PLP_OK);
    stop_recording(scene_.handle);
    EXPECT_EQ(TestTrace(file).info().complete, 1);
  }
  EXPECT_GT(SignalStorm::count(), 20);
}

TEST_F(Session, TheWallClockIsNobodysBusiness) {
  start();
  for (const auto by : {1h, -2h, 0h}) {
    set_wall_clock_ahead(by);
    EXPECT_TRUE(ticks_on());
  }
  EXPECT_LT(servo().skipped, 100'000u);
}

// As where a machine was halted for an hour: the servo leaves out what has passed, and the hand feels nothing
// until force has faded in anew.
TEST_F(Session, AnHourThatIsMissingEndsForceAndPasses) {
  const TestDevice device("sim:premium6dof");
  plp_hand_options hand = hand_options();
  hand.origin = at(0.0, -0.003, 0.0);
  ASSERT_EQ(plp_device_set_hand(device.handle, &hand), PLP_OK);
  ASSERT_EQ(plp_device_place_in_hand(device.handle), PLP_OK);
  ASSERT_EQ(plp_scene_set_device(scene_.handle, device.handle, nullptr), PLP_OK) << plp_last_error();
  ASSERT_EQ(plp_device_arm(device.handle), PLP_OK);
  start();
  const auto is_pushed = [&] {
    const plp_device_state state = device.state();
    return state.safety == PLP_SAFETY_ARMED && state.applied.force[1] > 0.1;
  };
  ASSERT_TRUE(comes_true(is_pushed));
  set_monotonic_clock_ahead(1h);
  EXPECT_TRUE(ticks_on());
  EXPECT_TRUE(comes_true([&] { return servo().skipped > 3'000'000u; }));
  EXPECT_TRUE(comes_true(is_pushed));
  EXPECT_EQ(plp_scene_stop(scene_.handle), PLP_OK);
  set_monotonic_clock_ahead(0h);
}

// How the child of a process with a running scene ends that does `work`; 98 if it hangs.
template <class Work>
int child_status(Work work) {
  const pid_t child = fork();
  if (child == 0) {
    is_forked = true;
    std::signal(SIGALRM, [](int) { std::_Exit(98); });
    alarm(10);
    work();
    std::exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(ForkDeathTest, AChildOfAProcessWithARunningScene) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        plp_scene_options options = TestScene::options_with(0.01);
        plp_scene scene = nullptr;
        const bool started =
            plp_scene_create(&options, &scene) == PLP_OK && plp_scene_start(scene, nullptr) == PLP_OK;
        const bool ends = child_status([] {}) == 0;
        const bool shuts_down = child_status([] { plp_shutdown_all(); }) == 0;
        const bool execs = child_status([] { execl("/bin/true", "true", nullptr); }) == 0;
        const bool goes_on = plp_scene_stop(scene) == PLP_OK && plp_scene_step(scene) == PLP_OK;
        std::exit(started && ends && shuts_down && execs && goes_on ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

// A program may go into the background first, and start its scene there.
TEST(ForkDeathTest, AChildMayHaveAServoOfItsOwn) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        plp_scene_options options = TestScene::options_with(0.01);
        plp_scene scene = nullptr;
        const bool made = plp_scene_create(&options, &scene) == PLP_OK;
        const bool before = plp_scene_start(scene, nullptr) == PLP_OK && plp_scene_stop(scene) == PLP_OK;
        const int child = child_status([&] {
          if (plp_scene_start(scene, nullptr) != PLP_OK) std::_Exit(1);
        });
        std::exit(made && before && child == 0 ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(ExitDeathTest, WhileOtherThreadsStepAndRead) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        static plp_scene stepped = nullptr;
        static plp_scene running = nullptr;
        static std::atomic<int> rounds = 0;
        plp_scene_options options = TestScene::options_with(0.01);
        const bool made = plp_scene_create(&options, &stepped) == PLP_OK &&
                          plp_scene_create(&options, &running) == PLP_OK &&
                          plp_scene_start(running, nullptr) == PLP_OK;
        std::thread([] {
          while (true) {
            plp_contacts contacts;
            plp_contacts_init(&contacts, sizeof contacts);
            plp_scene_step(stepped);
            plp_scene_get_contacts(running, &contacts);
            ++rounds;
          }
        }).detach();
        while (rounds < 100) std::this_thread::sleep_for(1ms);
        const bool shut_down = plp_shutdown_all() == PLP_OK;
        std::exit(made && shut_down ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace palpate::test
