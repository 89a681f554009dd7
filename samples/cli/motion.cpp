#include "samples/cli/motion.h"

#include <algorithm>
#include <fstream>

namespace palpate::cli {
namespace {

bool is_trace(const std::string& path) {
  constexpr std::string_view kMagic = "PLPTRACE";
  char beginning[kMagic.size()] = {};
  std::ifstream(path, std::ios::binary).read(beginning, sizeof beginning);
  return std::string_view(beginning, sizeof beginning) == kMagic;
}

}  // namespace

std::vector<plp_trace_body> body_and_tool() {
  std::vector<plp_trace_body> bodies(2);
  bodies[0].kind = PLP_BODY_STATIC;
  bodies[1].kind = PLP_BODY_TOOL;
  return bodies;
}

plp_body_options body_options(const plp_trace_body& recorded) {
  plp_body_options options;
  plp_body_options_init(&options, sizeof options);
  options.kind = static_cast<plp_body_kind>(recorded.kind);
  options.stiffness = recorded.stiffness;
  options.damping = recorded.damping;
  options.friction = recorded.friction;
  options.intangible = recorded.intangible;
  std::copy_n(recorded.reference_point, 3, options.reference_point);
  return options;
}

Motion::Motion(const std::string& path) {
  if (is_trace(path)) {
    open_trace(path);
  } else {
    poses_ = read_trajectory(path);
    bodies_ = body_and_tool();
  }
}

void Motion::open_trace(const std::string& path) {
  check(plp_trace_open(path.c_str(), trace_.receive()));
  plp_trace_info info;
  plp_trace_info_init(&info, sizeof info);
  check(plp_trace_get_info(trace_.get(), &info));
  if (info.ticks == 0) throw Failure(path + ": has no steps");
  take_bodies(path, info);
  for (std::uint64_t step = 0; step < info.ticks; ++step) {
    const plp_trace_tick read = tick(step);
    poses_.push_back({read.time, read.tool_pose});
  }
}

void Motion::take_bodies(const std::string& path, const plp_trace_info& info) {
  std::size_t tools = 0;
  for (std::uint64_t i = 0; i < info.bodies; ++i) {
    plp_trace_body& read = bodies_.emplace_back();
    plp_trace_body_init(&read, sizeof read);
    check(plp_trace_get_body(trace_.get(), i, &read));
    if (read.first_tick != 0 || read.end_tick != info.ticks) throw Failure(path + ": its bodies come and go");
    tools += read.kind == PLP_BODY_TOOL;
  }
  if (tools != 1) throw Failure(path + ": has no tool");
}

plp_scene_options Motion::options() const {
  plp_scene_options options;
  plp_scene_options_init(&options, sizeof options);
  check(plp_trace_get_options(trace_.get(), &options));
  return options;
}

void Motion::place(std::size_t step, plp_scene scene, const std::vector<plp_body>& bodies) const {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    check(plp_trace_place(trace_.get(), step, bodies_[i].body, scene, bodies[i]));
}

plp_trace_tick Motion::tick(std::size_t step) const {
  plp_trace_tick tick;
  plp_trace_tick_init(&tick, sizeof tick);
  check(plp_trace_read(trace_.get(), step, &tick));
  return tick;
}

}  // namespace palpate::cli
