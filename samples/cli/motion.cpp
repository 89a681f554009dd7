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

Motion::Motion(const std::string& path) {
  if (is_trace(path)) {
    open_trace(path);
  } else {
    poses_ = read_trajectory(path);
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
  for (std::uint64_t i = 0; i < info.bodies && info.bodies == 2; ++i) {
    plp_trace_body read;
    plp_trace_body_init(&read, sizeof read);
    check(plp_trace_get_body(trace_.get(), i, &read));
    if (read.first_tick != 0 || read.end_tick != info.ticks) throw Failure(path + ": its bodies come and go");
    tools += read.kind == PLP_BODY_TOOL;
    (read.kind == PLP_BODY_TOOL ? tool_ : body_) = read;
  }
  if (tools != 1) throw Failure(path + ": has not two bodies, one of them a tool");
}

plp_scene_options Motion::options() const {
  plp_scene_options options;
  plp_scene_options_init(&options, sizeof options);
  check(plp_trace_get_options(trace_.get(), &options));
  return options;
}

plp_body_options Motion::body_options(plp_body_kind kind) const {
  const plp_trace_body& recorded = kind == PLP_BODY_TOOL ? tool_ : body_;
  plp_body_options options;
  plp_body_options_init(&options, sizeof options);
  options.kind = kind;
  options.stiffness = recorded.stiffness;
  options.damping = recorded.damping;
  options.friction = recorded.friction;
  options.intangible = recorded.intangible;
  std::copy_n(recorded.reference_point, 3, options.reference_point);
  return options;
}

void Motion::place(std::size_t step, plp_scene scene, plp_body body, plp_body tool) const {
  check(plp_trace_place(trace_.get(), step, body_.body, scene, body));
  check(plp_trace_place(trace_.get(), step, tool_.body, scene, tool));
}

plp_trace_tick Motion::tick(std::size_t step) const {
  plp_trace_tick tick;
  plp_trace_tick_init(&tick, sizeof tick);
  check(plp_trace_read(trace_.get(), step, &tick));
  return tick;
}

}  // namespace palpate::cli
