#include "capi/src/handles.h"
#include "capi/src/numbers.h"
#include "capi/src/structs.h"

namespace palpate::capi {
namespace {

constexpr double kUsualRate = 1000.0;
constexpr double kLargestRate = 20'000.0;
constexpr int kLargestPriority = 99;
constexpr int kLargestCpu = 1023;

double rate_of(double rate) {
  if (rate == 0.0) return kUsualRate;
  if (!(checked_positive(rate, "options->rate") >= 1.0) || rate > kLargestRate)
    refuse_argument("options->rate", " is neither 0 nor between 1 and 20000");
  return rate;
}

int number_in(int number, int most, const char* name) {
  if (number < -1 || number > most)
    refuse(ErrorCode::kInvalidArgument, std::string(name) + " is not between -1 and " + std::to_string(most));
  return number;
}

ServoOptions servo_options(const plp_servo_options* given) {
  if (!given) return {};
  const plp_servo_options options = read_struct(given, "options");
  require(options.flags == 0, "options->flags has a flag that this version does not have");
  return {rate_of(options.rate), number_in(options.priority, kLargestPriority, "options->priority"),
          number_in(options.cpu, kLargestCpu, "options->cpu")};
}

void write_latency(const Latency& latency, double us[4]) {
  us[0] = latency.percentile_us(0.5);
  us[1] = latency.percentile_us(0.99);
  us[2] = latency.percentile_us(0.999);
  us[3] = latency.max_us();
}

plp_servo_state state_of(const ServoState& servo) {
  plp_servo_state state{};
  state.running = servo.running;
  state.priority = servo.grants.priority;
  state.cpu = servo.grants.cpu;
  state.wanted_rate = servo.wanted_rate_hz;
  state.rate = servo.statistics.rate_hz;
  state.ticks = servo.statistics.ticks;
  state.missed = servo.statistics.missed;
  state.skipped = servo.statistics.skipped;
  write_latency(servo.statistics.work, state.work_us);
  write_latency(servo.statistics.lateness, state.lateness_us);
  state.waiting_ticks = servo.counts.waiting_ticks;
  state.cut_ticks = servo.counts.cut_ticks;
  state.preparations = servo.counts.preparations;
  state.searches = servo.counts.searches;
  state.result_age = servo.result_age;
  return state;
}

// No thread outlives the process.
struct AtExit {
  ~AtExit() { SceneThreads::stop_all(); }
} at_exit;

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_servo_options_init(plp_servo_options* options, size_t size) {
  plp_servo_options filled{};
  filled.rate = kUsualRate;
  filled.cpu = ServoOptions::kAnyCpu;
  fill_struct(filled, options, size);
}

void plp_servo_state_init(plp_servo_state* state, size_t size) {
  fill_struct(plp_servo_state{}, state, size);
}

plp_result plp_scene_start(plp_scene scene, const plp_servo_options* options) {
  return guarded([&] {
    const auto object = scene_table().pin(bits_of(scene));
    require_handle(object, "scene");
    value_or_refuse(object->threads.start(servo_options(options)));
  });
}

plp_result plp_scene_stop(plp_scene scene) {
  return guarded([&] {
    const auto object = scene_table().pin(bits_of(scene));
    require_handle(object, "scene");
    object->threads.stop();
  });
}

plp_result plp_scene_get_servo(plp_scene scene, plp_servo_state* state) {
  return guarded([&] {
    const auto object = scene_table().pin(bits_of(scene));
    require_handle(object, "scene");
    write_struct(state_of(object->threads.state()), state, "state");
  });
}

plp_result plp_shutdown_all(void) {
  return guarded([] { SceneThreads::stop_all(); });
}
