#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <thread>

#include "samples/cli/commands.h"
#include "samples/cli/comparison.h"
#include "samples/cli/json_writer.h"
#include "samples/cli/stage.h"

namespace palpate::cli {
namespace {

void require_supported(const RunArguments& arguments) {
  if (arguments.mode) static_cast<void>(mode_of(*arguments.mode));
  if (arguments.global_every == 0u) throw Failure("--global-every 0: it is at least 1");
  if (arguments.law) static_cast<void>(law_of(*arguments.law));
  if (arguments.compare && arguments.threaded)
    throw Failure("--compare: not with --threaded, whose steps have no pose of their own");
}

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
  stage.move(0);
  stage.start(1.0 / seconds_a_pose);
  const auto start = std::chrono::steady_clock::now();
  const auto wait_until = [&](double seconds) {
    std::this_thread::sleep_until(start + std::chrono::duration<double>(seconds - poses.front().seconds));
  };
  for (std::size_t i = 0; i < poses.size(); ++i) {
    stage.move(i);
    wait_until(i + 1 < poses.size() ? poses[i + 1].seconds : poses[i].seconds + seconds_a_pose);
    ticks.push_back(stage.newest(i));
  }
  return stage.stop();
}

// Steps the same poses from scratch beside each tick; that takes no part in its time.
class Reference {
 public:
  Reference(const RunArguments& arguments, const plp_scene_options& options, const RunModels& models,
            const Motion& motion)
      : arguments_(from_scratch(arguments)),
        stage_(arguments_, from_scratch(options), models, motion),
        comparison_(scale_of(options, models, motion)) {}

  void compare(std::size_t pose, const plp_contacts& found) {
    static_cast<void>(stage_.step(pose));
    comparison_.add(found, stage_.contacts());
  }
  ComparisonSummary summary() const { return comparison_.summary(); }

 private:
  static RunArguments from_scratch(RunArguments arguments) {
    arguments.mode = "global";
    return arguments;
  }
  static plp_scene_options from_scratch(plp_scene_options options) {
    options.mode = PLP_MODE_GLOBAL;
    return options;
  }

  static Comparison scale_of(const plp_scene_options& options, const RunModels& models,
                             const Motion& motion) {
    constexpr double kOnePoint = 1e-9;  // of the body's diagonal
    const double unit = options.space.metres_per_unit;
    const double force = options.stiffness * options.cutoff * unit;
    double tool = 0.0, largest = 0.0;  // diagonals
    for (std::size_t i = 0; i < motion.bodies().size(); ++i) {
      double& diagonal = motion.bodies()[i].kind == PLP_BODY_TOOL ? tool : largest;
      diagonal = std::max(diagonal, models.diagonal(i));
    }
    return {force, 0.5 * tool * force, kOnePoint * largest / unit};
  }

  const RunArguments arguments_;
  Stage stage_;
  Comparison comparison_;
};

std::vector<Tick> run_stepped(const Motion& motion, Stage& stage, Reference* reference) {
  std::vector<Tick> ticks;
  ticks.reserve(motion.poses().size());
  for (std::size_t pose = 0; pose < motion.poses().size(); ++pose) {
    ticks.push_back(stage.step(pose));
    if (reference) reference->compare(pose, stage.contacts());
  }
  return ticks;
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

void write_comparison(JsonWriter& json, const ComparisonSummary& comparison) {
  json.key("comparison").open_object();
  json.field("sets", comparison.sets)
      .field("missed", comparison.missed)
      .field("spurious", comparison.spurious);
  json.field("force_error_rms", comparison.force_error_rms)
      .field("force_error_p99.9", comparison.force_error_p999);
  json.field("force_error_max", comparison.force_error_max);
  json.field("torque_error_rms", comparison.torque_error_rms)
      .field("torque_error_max", comparison.torque_error_max);
  json.close();
}

void print_comparison(const ComparisonSummary& comparison) {
  std::printf("of %zu local minimum distances %zu were missed, and %zu were spurious\n", comparison.sets,
              comparison.missed, comparison.spurious);
  std::printf(
      "the force was off by RMS %.2e, p99.9 %.2e, max %.2e of stiffness x cutoff, the torque by RMS %.2e, "
      "max "
      "%.2e of that at half the tool's diagonal\n",
      comparison.force_error_rms, comparison.force_error_p999, comparison.force_error_max,
      comparison.torque_error_rms, comparison.torque_error_max);
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

void write_recording(JsonWriter& json, const plp_recording& recording) {
  json.key("recording").open_object();
  json.field("ticks", recording.ticks).field("lost", recording.lost).field("bytes", recording.bytes);
  json.close();
}

void print_recording(const plp_recording& recording) {
  std::printf(
      "recorded %llu steps in %llu bytes, lost %llu\n", static_cast<unsigned long long>(recording.ticks),
      static_cast<unsigned long long>(recording.bytes), static_cast<unsigned long long>(recording.lost));
}

// What there is to tell beside the summary.
struct RunReport {
  std::optional<plp_servo_state> servo;
  std::optional<ComparisonSummary> comparison;
  std::optional<plp_recording> recording;
};

void print_json(const RunSummary& summary, const RunReport& report) {
  JsonWriter json(std::cout);
  json.open_object()
      .field("ticks", summary.ticks)
      .field("ticks_in_contact", summary.ticks_in_contact)
      .field("ticks_overlapping", summary.ticks_overlapping)
      .field("most_lmds", summary.most_lmds);
  const double local_us[] = {summary.local_us_p50, summary.local_us_p99, summary.local_us_p999,
                             summary.local_us_max};
  write_times(json, "local_us", local_us);
  summary.work.write(json);
  if (report.servo) write_servo(json, *report.servo);
  if (report.comparison) write_comparison(json, *report.comparison);
  if (report.recording) write_recording(json, *report.recording);
  json.close();
  std::cout << '\n';
}

void print_summary(const RunSummary& summary) {
  std::printf("%zu ticks, %zu of them in contact, %zu overlapping, at most %zu local minimum distances\n",
              summary.ticks, summary.ticks_in_contact, summary.ticks_overlapping, summary.most_lmds);
  std::printf("a tick took p50 %.1f, p99 %.1f, p99.9 %.1f, max %.1f us\n", summary.local_us_p50,
              summary.local_us_p99, summary.local_us_p999, summary.local_us_max);
  summary.work.print();
}

}  // namespace

void run_trajectory(const RunArguments& arguments) {
  require_supported(arguments);
  const Motion motion(arguments.trajectory);
  const plp_scene_options options = scene_options(arguments, motion);
  const double interval = arguments.threaded ? seconds_a_pose(motion.poses(), arguments.trajectory) : 0.0;
  const RunModels models(arguments, motion);
  Stage stage(arguments, options, models, motion);
  std::optional<Reference> reference;
  if (arguments.compare) reference.emplace(arguments, options, models, motion);
  std::vector<Tick> ticks;
  RunReport report;
  if (!arguments.record.empty()) stage.record(arguments.record);
  if (arguments.threaded) {
    report.servo = run_threaded(stage, motion.poses(), interval, ticks);
  } else {
    ticks = run_stepped(motion, stage, reference ? &*reference : nullptr);
  }
  if (!arguments.record.empty()) report.recording = stage.stop_recording();
  if (reference) report.comparison = reference->summary();
  if (!arguments.out.empty()) write_file(arguments.out, ticks);
  if (arguments.json) return print_json(summary_of(ticks), report);
  print_summary(summary_of(ticks));
  if (report.servo) print_servo(*report.servo);
  if (report.comparison) print_comparison(*report.comparison);
  if (report.recording) print_recording(*report.recording);
}

}  // namespace palpate::cli
