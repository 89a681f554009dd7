#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>

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

void require_supported(const RunArguments& arguments) {
  static_cast<void>(mode_of(arguments.mode));
  if (arguments.global_every == 0) throw Failure("--global-every 0: it is at least 1");
  if (arguments.law != "springs") throw Failure("--law " + arguments.law + ": supported is only springs");
}

// One model that stands still and one that is the tool.
class Stage {
 public:
  explicit Stage(const RunArguments& arguments) {
    plp_scene_options options;
    plp_scene_options_init(&options);
    options.cutoff = arguments.cutoff;
    options.stiffness = arguments.stiffness;
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

    plp_contacts contacts;
    plp_contacts_init(&contacts);
    check(plp_scene_get_contacts(scene_.get(), &contacts));
    const plp_work& work = contacts.work;
    return {at.seconds,          contacts.set_count, contacts.min_distance,
            contacts.wrench,     took.count(),       work.global_us,
            work.triangle_pairs, work.age,           contacts.overlap != 0};
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

void write_file(const std::string& path, const std::vector<Tick>& ticks) {
  std::ofstream file(path);
  if (file) write_csv(ticks, file);
  file.close();
  if (!file) throw Failure(path + ": cannot be written");
}

void print_json(const RunSummary& summary) {
  JsonWriter json(std::cout);
  json.open_object()
      .field("ticks", summary.ticks)
      .field("ticks_in_contact", summary.ticks_in_contact)
      .field("ticks_overlapping", summary.ticks_overlapping)
      .field("most_lmds", summary.most_lmds);
  json.key("local_us")
      .open_object()
      .field("p50", summary.local_us_p50)
      .field("p99", summary.local_us_p99)
      .field("p99.9", summary.local_us_p999)
      .field("max", summary.local_us_max)
      .close()
      .close();
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
  Stage stage(arguments);
  std::vector<Tick> ticks;
  ticks.reserve(poses.size());
  for (const TimedPose& pose : poses) ticks.push_back(stage.step(pose));
  if (!arguments.out.empty()) write_file(arguments.out, ticks);
  if (arguments.json) {
    print_json(summary_of(ticks));
  } else {
    print_summary(summary_of(ticks));
  }
}

}  // namespace palpate::cli
