#include "samples/cli/stage.h"

#include <chrono>

namespace palpate::cli {

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

plp_scene_options scene_options(const RunArguments& arguments, const Motion& motion) {
  plp_scene_options options;
  plp_scene_options_init(&options, sizeof options);
  if (motion.recorded()) options = motion.options();
  if (!motion.recorded() && !arguments.cutoff) throw Failure("--cutoff is required, but with a trace");
  options.cutoff = arguments.cutoff.value_or(options.cutoff);
  options.stiffness = arguments.stiffness.value_or(options.stiffness);
  options.damping = arguments.damping.value_or(options.damping);
  options.friction = arguments.friction.value_or(options.friction);
  options.stiffness_cap = arguments.stiffness_cap.value_or(options.stiffness_cap);
  options.global_every = arguments.global_every.value_or(options.global_every);
  if (arguments.mode) options.mode = mode_of(*arguments.mode);
  if (arguments.law) options.law = law_of(*arguments.law);
  return options;
}

Stage::Stage(const RunArguments& arguments, const plp_scene_options& options, const RunModels& models,
             const Motion& motion)
    : arguments_(arguments), motion_(motion) {
  check(plp_scene_create(&options, scene_.receive()));
  for (std::size_t i = 0; i < motion.bodies().size(); ++i) {
    bodies_.push_back(add(models[i], motion.bodies()[i]));
    if (motion.bodies()[i].kind == PLP_BODY_TOOL) tool_ = bodies_.back();
  }
}

void Stage::move(std::size_t pose) {
  if (!motion_.recorded()) return check(plp_scene_set_pose(scene_.get(), tool_, &motion_.poses()[pose].pose));
  follow_settings(motion_.tick(pose));
  motion_.place(pose, scene_.get(), bodies_);
}

// What was not asked for otherwise changes as it did when the trace was recorded.
void Stage::follow_settings(const plp_trace_tick& tick) {
  if (!arguments_.cutoff) check(plp_scene_set_cutoff(scene_.get(), tick.cutoff));
  if (!arguments_.stiffness) check(plp_scene_set_stiffness(scene_.get(), tick.stiffness));
  if (!arguments_.damping) check(plp_scene_set_damping(scene_.get(), tick.damping));
  if (!arguments_.friction) check(plp_scene_set_friction(scene_.get(), tick.friction));
  if (!arguments_.stiffness_cap) check(plp_scene_set_stiffness_cap(scene_.get(), tick.stiffness_cap));
  if (!arguments_.mode) check(plp_scene_set_mode(scene_.get(), tick.mode));
  if (!arguments_.law) check(plp_scene_set_law(scene_.get(), tick.law));
}

Tick Stage::step(std::size_t pose) {
  move(pose);
  const auto start = std::chrono::steady_clock::now();
  check(plp_scene_step(scene_.get()));
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;

  Tick tick = newest(pose);
  tick.local_us = took.count();
  return tick;
}

void Stage::start(double rate) {
  plp_servo_options options;
  plp_servo_options_init(&options, sizeof options);
  options.rate = rate;
  check(plp_scene_start(scene_.get(), &options));
}

Tick Stage::newest(std::size_t pose) const {
  const plp_contacts found = contacts();
  return {motion_.poses()[pose].seconds,
          found.set_count,
          found.min_distance,
          found.wrench,
          found.search_us,
          found.work,
          found.overlap != 0};
}

plp_servo_state Stage::stop() {
  check(plp_scene_stop(scene_.get()));
  plp_servo_state state;
  plp_servo_state_init(&state, sizeof state);
  check(plp_scene_get_servo(scene_.get(), &state));
  return state;
}

plp_recording Stage::stop_recording() {
  plp_recording recording;
  plp_recording_init(&recording, sizeof recording);
  check(plp_scene_stop_recording(scene_.get(), &recording));
  return recording;
}

plp_contacts Stage::contacts() const {
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  check(plp_scene_get_contacts(scene_.get(), &contacts));
  return contacts;
}

plp_body Stage::add(plp_model model, const plp_trace_body& recorded) {
  plp_body_options options = body_options(recorded);
  options.model = model;
  plp_body body = 0;
  check(plp_scene_add_body(scene_.get(), &options, &body));
  return body;
}

}  // namespace palpate::cli
