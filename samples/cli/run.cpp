#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <thread>

#include "samples/cli/commands.h"
#include "samples/cli/handles.h"
#include "samples/cli/json_writer.h"
#include "samples/cli/tick.h"
#include "samples/cli/trajectory.h"

namespace palpate::cli {
namespace {

plp_mode mode_of(const std::string& name) {
  if (name == "global") return PLP_MODE_GLOBAL;
  if (name == "descent") return PLP_MODE_DESCENT;
  if (name == "certified") return PLP_MODE_CERTIFIED;
  throw Failure("--mode " + name + ": it is global, descent or certified");
}

plp_law law_of(const std::string& name) {
  if (name == "springs") return PLP_LAW_SPRINGS;
  if (name == "smooth") return PLP_LAW_SMOOTH;
  throw Failure("--law " + name + ": it is springs or smooth");
}

void require_supported(const RunArguments& arguments) {
  static_cast<void>(mode_of(arguments.mode));
  if (arguments.global_every == 0) throw Failure("--global-every 0: it is at least 1");
  static_cast<void>(law_of(arguments.law));
}

// One model that stands still and one that is the tool.
class Stage {
 public:
  explicit Stage(const RunArguments& arguments) {
    plp_scene_options options;
    plp_scene_options_init(&options);
    options.cutoff = arguments.cutoff;
    options.stiffness = arguments.stiffness;
    options.law = law_of(arguments.law);
    options.damping = arguments.damping;
    options.friction = arguments.friction;
    options.stiffness_cap = arguments.stiffness_cap;
    options.mode = mode_of(arguments.mode);
    options.global_every = arguments.global_every;
    check(plp_scene_create(&options, scene_.receive()));
    add(load_model(arguments.a), PLP_BODY_STATIC);
    tool_ = add(load_model(arguments.b), PLP_BODY_TOOL);
  }

  Tick step(const TimedPose& at) {
    const auto start = std::chrono::steady_clock::now();
    check(plp_scene_set_pose(scene_.get(), tool_, &at.pose));
    check(plp_scene_step(scene_.get()));
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;

    Tick tick = newest(at);
    tick.local_us = took.count();
    return tick;
  }

  // The same while a servo of so many steps a second runs beside the caller.
  void start(double rate) {
    plp_servo_options options;
    plp_servo_options_init(&options);
    options.rate = rate;
    check(plp_scene_start(scene_.get(), &options));
  }
  void move(const TimedPose& at) { check(plp_scene_set_pose(scene_.get(), tool_, &at.pose)); }
  Tick newest(const TimedPose& at) const {
    plp_contacts contacts;
    plp_contacts_init(&contacts);
    check(plp_scene_get_contacts(scene_.get(), &contacts));
    const plp_work& work = contacts.work;
    return {at.seconds,          contacts.set_count, contacts.min_distance,
            contacts.wrench,     contacts.search_us, work.global_us,
            work.triangle_pairs, work.age,           contacts.overlap != 0};
  }
  plp_servo_state stop() {
    check(plp_scene_stop(scene_.get()));
    plp_servo_state state;
    plp_servo_state_init(&state);
    check(plp_scene_get_servo(scene_.get(), &state));
    return state;
  }

 private:
  plp_body add(const OwnedModel& model, plp_body_kind kind) {
    plp_body_options options;
    plp_body_options_init(&options);
    options.kind = kind;
    options.model = model.get();
    plp_body body = 0;
    check(plp_scene_add_body(scene_.get(), &options, &body));
    return body;
  }

  OwnedScene scene_;
  plp_body tool_ = 0;
};

// Of a trajectory that a servo follows.
double seconds_a_pose(const std::vector<TimedPose>& poses, const std::string& file) {
  for (std::size_t i = 1; i < poses.size(); ++i)
    if (!(poses[i].seconds > poses[i - 1].seconds)) throw Failure(file + ": its times do not increase");
  if (poses.size() < 2) throw Failure(file + ": has one pose, which gives no rate");
  return (poses.back().seconds - poses.front().seconds) / static_cast<double>(poses.size() - 1);
}

// Plays the trajectory at its own rate. A row is the newest outcome just before the next pose is due.
plp_servo_state run_threaded(Stage& stage, const std::vector<TimedPose>& poses, double seconds_a_pose,
                             std::vector<Tick>& ticks) {
  stage.move(poses.front());
  stage.start(1.0 / seconds_a_pose);
  const auto start = std::chrono::steady_clock::now();
  const auto wait_until = [&](double seconds) {
    std::this_thread::sleep_until(start + std::chrono::duration<double>(seconds - poses.front().seconds));
  };
  for (std::size_t i = 0; i < poses.size(); ++i) {
    stage.move(poses[i]);
    wait_until(i + 1 < poses.size() ? poses[i + 1].seconds : poses[i].seconds + seconds_a_pose);
    ticks.push_back(stage.newest(poses[i]));
  }
  return stage.stop();
}

void write_file(const std::string& path, const std::vector<Tick>& ticks) {
  std::ofstream file(path);
  if (file) write_csv(ticks, file);
  file.close();
  if (!file) throw Failure(path + ": cannot be written");
}

void write_times(JsonWriter& json, const char* name, const double us[4]) {
  json.key(name).open_object();
  json.field("p50", us[0]).field("p99", us[1]).field("p99.9", us[2]).field("max", us[3]).close();
}

void write_servo(JsonWriter& json, const plp_servo_state& servo) {
  json.key("servo").open_object();
  json.field("ticks", servo.ticks).field("rate", servo.rate).field("missed", servo.missed);
  write_times(json, "work_us", servo.work_us);
  write_times(json, "lateness_us", servo.lateness_us);
  json.close();
}

void print_servo(const plp_servo_state& servo) {
  std::printf("the servo ran %llu steps at %.1f a second, %llu of them too long\n",
              static_cast<unsigned long long>(servo.ticks), servo.rate,
              static_cast<unsigned long long>(servo.missed));
  std::printf(
      "a step took p50 %.1f, p99 %.1f, p99.9 %.1f, max %.1f us and came late by p50 %.1f, p99 %.1f, "
      "p99.9 %.1f, max %.1f us\n",
      servo.work_us[0], servo.work_us[1], servo.work_us[2], servo.work_us[3], servo.lateness_us[0],
      servo.lateness_us[1], servo.lateness_us[2], servo.lateness_us[3]);
}

void print_json(const RunSummary& summary, const std::optional<plp_servo_state>& servo) {
  JsonWriter json(std::cout);
  json.open_object()
      .field("ticks", summary.ticks)
      .field("ticks_in_contact", summary.ticks_in_contact)
      .field("ticks_overlapping", summary.ticks_overlapping)
      .field("most_lmds", summary.most_lmds);
  const double local_us[] = {summary.local_us_p50, summary.local_us_p99, summary.local_us_p999,
                             summary.local_us_max};
  write_times(json, "local_us", local_us);
  if (servo) write_servo(json, *servo);
  json.close();
  std::cout << '\n';
}

void print_summary(const RunSummary& summary) {
  std::printf("%zu ticks, %zu of them in contact, %zu overlapping, at most %zu local minimum distances\n",
              summary.ticks, summary.ticks_in_contact, summary.ticks_overlapping, summary.most_lmds);
  std::printf("a tick took p50 %.1f, p99 %.1f, p99.9 %.1f, max %.1f us\n", summary.local_us_p50,
              summary.local_us_p99, summary.local_us_p999, summary.local_us_max);
}

}  // namespace

void run_trajectory(const RunArguments& arguments) {
  require_supported(arguments);
  const std::vector<TimedPose> poses = read_trajectory(arguments.trajectory);
  const double interval = arguments.threaded ? seconds_a_pose(poses, arguments.trajectory) : 0.0;
  Stage stage(arguments);
  std::vector<Tick> ticks;
  ticks.reserve(poses.size());
  std::optional<plp_servo_state> servo;
  if (arguments.threaded) {
    servo = run_threaded(stage, poses, interval, ticks);
  } else {
    for (const TimedPose& pose : poses) ticks.push_back(stage.step(pose));
  }
  if (!arguments.out.empty()) write_file(arguments.out, ticks);
  if (arguments.json) return print_json(summary_of(ticks), servo);
  print_summary(summary_of(ticks));
  if (servo) print_servo(*servo);
}

}  // namespace palpate::cli
