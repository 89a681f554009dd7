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

Stage::Stage(const RunArguments& arguments, plp_mode mode, const RunModels& models) {
  plp_scene_options options;
  plp_scene_options_init(&options, sizeof options);
  options.cutoff = arguments.cutoff;
  options.stiffness = arguments.stiffness;
  options.law = law_of(arguments.law);
  options.damping = arguments.damping;
  options.friction = arguments.friction;
  options.stiffness_cap = arguments.stiffness_cap;
  options.mode = mode;
  options.global_every = arguments.global_every;
  check(plp_scene_create(&options, scene_.receive()));
  add(models.body, PLP_BODY_STATIC);
  tool_ = add(models.tool, PLP_BODY_TOOL);
}

Tick Stage::step(const TimedPose& at) {
  const auto start = std::chrono::steady_clock::now();
  move(at);
  check(plp_scene_step(scene_.get()));
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;

  Tick tick = newest(at);
  tick.local_us = took.count();
  return tick;
}

void Stage::start(double rate) {
  plp_servo_options options;
  plp_servo_options_init(&options, sizeof options);
  options.rate = rate;
  check(plp_scene_start(scene_.get(), &options));
}

Tick Stage::newest(const TimedPose& at) const {
  const plp_contacts found = contacts();
  return {at.seconds,      found.set_count, found.min_distance, found.wrench,
          found.search_us, found.work,      found.overlap != 0};
}

plp_servo_state Stage::stop() {
  check(plp_scene_stop(scene_.get()));
  plp_servo_state state;
  plp_servo_state_init(&state, sizeof state);
  check(plp_scene_get_servo(scene_.get(), &state));
  return state;
}

plp_contacts Stage::contacts() const {
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  check(plp_scene_get_contacts(scene_.get(), &contacts));
  return contacts;
}

plp_body Stage::add(const OwnedModel& model, plp_body_kind kind) {
  plp_body_options options;
  plp_body_options_init(&options, sizeof options);
  options.kind = kind;
  options.model = model.get();
  plp_body body = 0;
  check(plp_scene_add_body(scene_.get(), &options, &body));
  return body;
}

}  // namespace palpate::cli
