// Everything at once through the C interface: bodies added, moved and removed, settings switched, the servo
// started and stopped, contacts read, each by threads of their own. For longer than the few seconds of a
// usual run set PALPATE_STORM_SECONDS.
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>
#include <vector>

#include "tests/capi/shapes.h"
#include "tests/runtime/threads.h"

namespace palpate::test {
namespace {

constexpr std::uint64_t kSeed = 2024;
constexpr double kCutoff = 0.2;
constexpr double kLargestCutoff = 1.5 * kCutoff;

double storm_seconds() {
  const char* const given = std::getenv("PALPATE_STORM_SECONDS");
  return given ? std::atof(given) : 3.0;
}

class Dice {
 public:
  explicit Dice(std::uint64_t thread) : generator_(kSeed + thread) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t count) { return generator_() % count; }
  plp_pose pose(double reach) {
    return {{uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)},
            {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)}};
  }

 private:
  std::mt19937_64 generator_;
};

class Storm {
 public:
  Storm() : scene_(kCutoff) { scene_.add(ring_.handle, PLP_BODY_STATIC, at(0, 0, 0)); }

  void run(double seconds) {
    std::vector<std::thread> threads;
    const auto start = [&](auto work) {
      threads.emplace_back([this, work, dice = Dice(threads.size())]() mutable {
        while (!over_) (this->*work)(dice), ++rounds_;
      });
    };
    start(&Storm::change_bodies);
    start(&Storm::change_bodies);
    start(&Storm::move_tools);
    start(&Storm::switch_settings);
    start(&Storm::start_and_stop);
    start(&Storm::read_contacts);
    start(&Storm::read_servo);
    start(&Storm::change_hands);
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    over_ = true;
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(plp_scene_stop(scene_.handle), PLP_OK);
  }

  void print() const {
    std::printf(
        "seed %llu: %llu rounds, %llu outcomes read, %llu points of LMDs, %llu servo ticks, %llu starts\n",
        number(kSeed), number(rounds_), number(outcomes_), number(points_), number(ticks_), number(starts_));
  }
  void expect_thorough() const {
    EXPECT_EQ(surprises_, 0u);
    EXPECT_EQ(wrong_contacts_, 0u);
    EXPECT_GT(points_, 0u);
    EXPECT_GT(starts_, 1u);
    EXPECT_GT(ticks_, 0u);
  }

 private:
  static unsigned long long number(std::uint64_t count) { return count; }

  // Other results than `or_else` are surprises.
  void expect(plp_result result, plp_result or_else = PLP_OK) {
    if (result == PLP_OK || result == or_else) return;
    if (++surprises_ < 10) std::printf("%s: %s\n", plp_result_string(result), plp_last_error());
  }

  void change_bodies(Dice& dice) {
    std::vector<plp_body> bodies;
    for (int i = 0; i < 40; ++i) {
      if (bodies.size() < 8) {
        plp_body_options options;
        plp_body_options_init(&options, sizeof options);
        options.model = dice.below(2) ? ring_.handle : cube_.handle;
        options.kind = dice.below(2) ? PLP_BODY_STATIC : PLP_BODY_MOVING;
        options.pose = dice.pose(3.0);
        plp_body body = 0;
        expect(plp_scene_add_body(scene_.handle, &options, &body));
        bodies.push_back(body);
      }
      const plp_body chosen = bodies[dice.below(bodies.size())];
      const plp_pose pose = dice.pose(2.5);
      expect(plp_scene_set_pose(scene_.handle, chosen, &pose));
      plp_pose read;
      expect(plp_scene_get_pose(scene_.handle, chosen, &read));
      if (dice.below(4) == 0) {
        expect(plp_scene_remove_body(scene_.handle, bodies.back()));
        if (plp_scene_remove_body(scene_.handle, bodies.back()) != PLP_ERROR_INVALID_HANDLE) ++surprises_;
        bodies.pop_back();
      }
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
    for (const plp_body body : bodies) expect(plp_scene_remove_body(scene_.handle, body));
  }

  // Takes the tool away and puts another in its place; slides it over the ring.
  void move_tools(Dice& dice) {
    plp_body_options options;
    plp_body_options_init(&options, sizeof options);
    options.kind = PLP_BODY_TOOL;
    options.model = dice.below(2) ? cube_.handle : small_ring_.handle;
    options.pose = at(1.7, 0, 0);
    plp_body tool = 0;
    expect(plp_scene_add_body(scene_.handle, &options, &tool));
    for (int i = 0; i < 200 && !over_; ++i) {
      const plp_pose pose = {{1.55 + 0.1 * std::sin(0.05 * i), 0.002 * i, 0.1 * std::cos(0.03 * i)},
                             {0.0, 0.001 * i, 0.0, 1.0}};
      expect(plp_scene_set_pose(scene_.handle, tool, &pose));
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    expect(plp_scene_remove_body(scene_.handle, tool));
  }

  void switch_settings(Dice& dice) {
    expect(plp_scene_set_mode(scene_.handle, static_cast<std::int32_t>(dice.below(3))));
    expect(plp_scene_set_law(scene_.handle, static_cast<std::int32_t>(dice.below(2))));
    expect(plp_scene_set_cutoff(scene_.handle, dice.uniform(0.5 * kCutoff, kLargestCutoff)));
    expect(plp_scene_set_stiffness(scene_.handle, dice.uniform(0.0, 1000.0)));
    std::this_thread::sleep_for(std::chrono::milliseconds(7));
  }

  // The tool goes from hand to hand, among them none.
  void change_hands(Dice& dice) {
    plp_device device = nullptr;
    expect(plp_device_open(dice.below(2) ? "sim:premium6dof" : "sim:touch", &device));
    plp_hand_options hand;
    plp_hand_options_init(&hand, sizeof hand);
    hand.script = PLP_HAND_SLIDE;
    hand.period = 0.05;
    expect(plp_device_set_hand(device, &hand));
    plp_device_mapping mapping;
    plp_device_mapping_init(&mapping, sizeof mapping);
    mapping.scene_from_base.position[0] = 1.7;
    expect(plp_scene_set_device(scene_.handle, device, &mapping));
    expect(plp_device_arm(device));
    for (int i = 0; i < 20; ++i) {
      plp_device_state state;
      plp_device_state_init(&state, sizeof state);
      expect(plp_device_get_state(device, &state));
      if (dice.below(8) == 0) expect(plp_device_disarm(device));
      if (dice.below(8) == 0) expect(plp_device_place_in_hand(device));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    expect(plp_device_release(device));  // the scene keeps it
    if (dice.below(2)) expect(plp_scene_set_device(scene_.handle, nullptr, nullptr));
  }

  void start_and_stop(Dice& dice) {
    plp_servo_options options;
    plp_servo_options_init(&options, sizeof options);
    options.rate = 500.0 * static_cast<double>(1 + dice.below(3));
    options.priority = -1;
    expect(plp_scene_start(scene_.handle, &options));
    ++starts_;
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + dice.below(200)));
    if (dice.below(8) == 0) {
      expect(plp_shutdown_all());
    } else {
      expect(plp_scene_stop(scene_.handle));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(dice.below(10)));
  }

  void read_contacts(Dice& dice) {
    if (dice.below(3) == 0) expect(plp_scene_step(scene_.handle), PLP_ERROR_WRONG_STATE);
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    expect(plp_scene_get_contacts(scene_.handle, &contacts));
    ++outcomes_;
    points_ += contacts.lmd_count;
    if (!hold(contacts)) ++wrong_contacts_;
    std::this_thread::sleep_for(std::chrono::microseconds(400));
  }

  void read_servo(Dice&) {
    plp_servo_state state;
    plp_servo_state_init(&state, sizeof state);
    expect(plp_scene_get_servo(scene_.handle, &state));
    if (state.ticks > ticks_) ticks_ = state.ticks;
    if (state.work_us[0] > state.work_us[3]) ++surprises_;
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }

  // What is true of every outcome.
  static bool hold(const plp_contacts& contacts) {
    for (const double* vector : {contacts.wrench.force, contacts.wrench.torque})
      for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(vector[axis])) return false;
    std::vector<double> weights(contacts.set_count, 0.0);
    std::vector<bool> listed(contacts.set_count, false);
    for (std::size_t i = 0; i < contacts.lmd_count; ++i) {
      const plp_lmd& lmd = contacts.lmds[i];
      const double length = std::hypot(lmd.normal[0], lmd.normal[1], lmd.normal[2]);
      if (!(lmd.distance > 0.0) || lmd.distance > kLargestCutoff * (1 + 1e-9)) return false;
      if (std::abs(length - 1.0) > 1e-6 || lmd.set >= contacts.set_count) return false;
      if (lmd.body_a == 0 || lmd.body_b == 0 || lmd.distance < contacts.min_distance) return false;
      weights[lmd.set] += lmd.weight;
      listed[lmd.set] = true;
    }
    for (std::size_t set = 0; set < weights.size(); ++set)
      if (listed[set] && std::abs(weights[set] - 1.0) > 1e-9) return false;
    return contacts.lmd_count > 0 || std::isinf(contacts.min_distance) ||
           (contacts.status & PLP_STATUS_CUT) != 0;
  }

  const TestModel ring_{torus(1.0, 0.25, 48, 24)};
  const TestModel small_ring_{torus(0.3, 0.1, 24, 12)};
  const TestModel cube_{box(0.25f, 0.25f, 0.25f)};
  TestScene scene_;
  std::atomic<bool> over_ = false;
  std::atomic<std::uint64_t> rounds_ = 0, outcomes_ = 0, points_ = 0, ticks_ = 0, starts_ = 0;
  std::atomic<std::uint64_t> surprises_ = 0, wrong_contacts_ = 0;
};

TEST(Storm, EverythingAtOnce) {
  Storm storm;
  const std::size_t before = thread_count();
  storm.run(storm_seconds());
  storm.print();
  storm.expect_thorough();
  EXPECT_EQ(settled_thread_count(before), before) << "a thread was left behind";
}

// Scenes are released while their servos run.
TEST(Storm, ReleaseStopsTheServo) {
  const TestModel cube(box(0.25f, 0.25f, 0.25f));
  const std::size_t before = thread_count();
  for (int i = 0; i < 20; ++i) {
    TestScene scene(kCutoff);
    scene.add(cube.handle, PLP_BODY_STATIC, at(0, 0, 0));
    scene.add(cube.handle, PLP_BODY_TOOL, at(0.6, 0, 0));
    plp_servo_options options;
    plp_servo_options_init(&options, sizeof options);
    options.priority = -1;
    ASSERT_EQ(plp_scene_start(scene.handle, &options), PLP_OK);
    EXPECT_GT(thread_count(), before);
  }
  EXPECT_EQ(settled_thread_count(before), before);
}

TEST(Servo, RefusesWhatItCannotDo) {
  TestScene scene(kCutoff);
  plp_servo_options options;
  plp_servo_options_init(&options, sizeof options);
  for (const double rate : {-1.0, 0.5, 1e6, std::nan("")}) {
    options.rate = rate;
    EXPECT_EQ(plp_scene_start(scene.handle, &options), PLP_ERROR_INVALID_ARGUMENT) << rate;
  }
  options.rate = 0.0;
  options.flags = 1;
  EXPECT_EQ(plp_scene_start(scene.handle, &options), PLP_ERROR_INVALID_ARGUMENT);
  options.flags = 0;
  options.priority = 100;
  EXPECT_EQ(plp_scene_start(scene.handle, &options), PLP_ERROR_INVALID_ARGUMENT);
  options.priority = -1;
  options.cpu = -2;
  EXPECT_EQ(plp_scene_start(scene.handle, &options), PLP_ERROR_INVALID_ARGUMENT);
  options.cpu = -1;
  options.struct_size = 8;
  EXPECT_EQ(plp_scene_start(scene.handle, &options), PLP_ERROR_INVALID_ARGUMENT);
  options.struct_size = sizeof options;
  EXPECT_EQ(plp_scene_start(nullptr, &options), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_stop(nullptr), PLP_ERROR_INVALID_HANDLE);

  EXPECT_EQ(plp_scene_stop(scene.handle), PLP_OK) << "nothing runs";
  ASSERT_EQ(plp_scene_start(scene.handle, &options), PLP_OK);
  EXPECT_EQ(plp_scene_start(scene.handle, &options), PLP_ERROR_WRONG_STATE);
  EXPECT_EQ(plp_scene_step(scene.handle), PLP_ERROR_WRONG_STATE);
  EXPECT_EQ(plp_shutdown_all(), PLP_OK);
  EXPECT_EQ(plp_shutdown_all(), PLP_OK);
  EXPECT_EQ(plp_scene_step(scene.handle), PLP_OK);
  plp_servo_state state;
  plp_servo_state_init(&state, sizeof state);
  EXPECT_EQ(plp_scene_get_servo(scene.handle, &state), PLP_OK);
  state.struct_size = 8;
  EXPECT_EQ(plp_scene_get_servo(scene.handle, &state), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_get_servo(scene.handle, nullptr), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(state.running, 0);
  EXPECT_EQ(state.wanted_rate, 1000.0);
}

// A process that ends while a servo runs ends well.
TEST(ServoDeathTest, ExitStopsTheServo) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        static plp_scene scene = nullptr;
        plp_scene_options options = TestScene::options_with(kCutoff);
        const bool started =
            plp_scene_create(&options, &scene) == PLP_OK && plp_scene_start(scene, nullptr) == PLP_OK;
        std::exit(started ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace palpate::test
