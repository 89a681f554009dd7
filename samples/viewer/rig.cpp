#include "samples/viewer/rig.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace palpate::viewer {
namespace {

using cli::check;

constexpr double kTick = 1e-3;  // s
// A scene of this diagonal is worked on without scaling: it fits into the reach of a desktop device.
constexpr double kReach = 0.25;

plp_scene_options options_of(const Arguments& arguments) {
  const Settings& settings = arguments.settings;
  plp_scene_options options;
  plp_scene_options_init(&options, sizeof options);
  options.time_step = kTick;
  if (arguments.replay && arguments.replay->recorded()) options = arguments.replay->options();
  options.cutoff = settings.cutoff;
  options.stiffness = settings.stiffness;
  options.damping = settings.damping;
  options.stiffness_cap = settings.stiffness_cap;
  options.friction = settings.friction;
  options.mode = settings.mode;
  options.law = settings.law;
  return options;
}

plp_device_mapping mapping_of(const Content& content) {
  plp_device_mapping mapping;
  plp_device_mapping_init(&mapping, sizeof mapping);
  mapping.scene_from_base =
      pose_of({content.place.contact * content.tool->centre(), Quat(1.0, 0.0, 0.0, 0.0)});
  if (content.arguments.motion == MotionKind::kOrbit)
    mapping.scene_from_base = pose_of({content.place.centre, Quat(1.0, 0.0, 0.0, 0.0)});
  mapping.handle_from_tool = pose_of({-content.tool->centre(), Quat(1.0, 0.0, 0.0, 0.0)});
  mapping.motion_scale = std::max(content.scene->diagonal(), content.tool->diagonal()) / kReach;
  mapping.force_scale = 1.0 / mapping.motion_scale;  // the hand feels the scene's stiffness
  return mapping;
}

}  // namespace

Rig::Rig(const Content& content) : settings_(content.arguments.settings) {
  const plp_scene_options options = options_of(content.arguments);
  check(plp_scene_create(&options, scene_.receive()));
  const cli::Motion* replay = content.arguments.replay.get();
  if (replay && replay->recorded()) recorded_ = settings_of(replay->options());
  for (const plp_trace_body& recorded : replay ? replay->bodies() : cli::body_and_tool()) {
    const bool tool = recorded.kind == PLP_BODY_TOOL;
    bodies_.push_back(add(tool ? *content.tool : *content.scene, cli::body_options(recorded),
                          tool ? content.place.start : Placement{}));
    if (tool) tool_ = bodies_.back();
  }
  if (!content.arguments.device.empty()) give_to_device(content);
}

void Rig::apply(const Settings& settings) {
  const plp_scene scene = scene_.get();
  if (settings.cutoff != settings_.cutoff) check(plp_scene_set_cutoff(scene, settings.cutoff));
  if (settings.stiffness != settings_.stiffness) check(plp_scene_set_stiffness(scene, settings.stiffness));
  if (settings.damping != settings_.damping) check(plp_scene_set_damping(scene, settings.damping));
  if (settings.stiffness_cap != settings_.stiffness_cap)
    check(plp_scene_set_stiffness_cap(scene, settings.stiffness_cap));
  if (settings.friction != settings_.friction) check(plp_scene_set_friction(scene, settings.friction));
  if (settings.mode != settings_.mode) check(plp_scene_set_mode(scene, settings.mode));
  if (settings.law != settings_.law) check(plp_scene_set_law(scene, settings.law));
  settings_ = settings;
}

void Rig::start() {
  if (runs_) return;
  check(plp_scene_start(scene_.get(), nullptr));
  runs_ = true;
}

void Rig::stop() {
  check(plp_scene_stop(scene_.get()));
  runs_ = false;
}

void Rig::step() {
  const auto start = std::chrono::steady_clock::now();
  check(plp_scene_step(scene_.get()));
  step_us_ = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  ++steps_;
}

void Rig::arm(bool on) {
  if (has_device()) check(on ? plp_device_arm(device_.get()) : plp_device_disarm(device_.get()));
}

void Rig::set_grip(plp_grip grip) {
  hand_.grip = grip;
  if (simulated_) check(plp_device_set_hand(device_.get(), &hand_));
}

void Rig::place_tool(const plp_pose& tool) {
  check(plp_scene_set_pose(scene_.get(), tool_, &tool));
}

void Rig::follow(const cli::Motion& motion, std::size_t row) {
  if (!motion.recorded()) return place_tool(motion.poses()[row].pose);
  const Settings now = settings_of(motion.tick(row));
  apply(changed(settings_, std::exchange(recorded_, now), now));
  motion.place(row, scene_.get(), bodies_);
}

void Rig::lead_hand(const Placement& from, const Placement& to, double seconds) {
  const std::array times = {0.0, seconds};
  const std::array poses = {pose_of(base_from_tool(from)), pose_of(base_from_tool(to))};
  check(plp_device_set_hand_poses(device_.get(), times.data(), poses.data(), times.size()));
}

void Rig::lead_hand(const std::vector<cli::TimedPose>& along) {
  std::vector<double> times;
  std::vector<plp_pose> poses;
  for (const cli::TimedPose& at : along) {
    times.push_back(at.seconds);
    poses.push_back(pose_of(base_from_tool(placement_of(at.pose))));
  }
  check(plp_device_set_hand_poses(device_.get(), times.data(), poses.data(), times.size()));
}

void Rig::record(const std::string& path) {
  check(plp_scene_record(scene_.get(), path.c_str()));
}

plp_recording Rig::stop_recording() {
  plp_recording recording;
  plp_recording_init(&recording, sizeof recording);
  check(plp_scene_stop_recording(scene_.get(), &recording));
  return recording;
}

plp_recording Rig::recording() const {
  plp_recording recording;
  plp_recording_init(&recording, sizeof recording);
  check(plp_scene_get_recording(scene_.get(), &recording));
  return recording;
}

plp_contacts Rig::contacts() const {
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  check(plp_scene_get_contacts(scene_.get(), &contacts));
  return contacts;
}

Placement Rig::tool() const {
  if (!has_device()) {
    plp_pose pose;
    check(plp_scene_get_pose(scene_.get(), tool_, &pose));
    return placement_of(pose);
  }
  Placement handle = placement_of(device_state().pose);
  handle.position *= mapping_.motion_scale;
  return placement_of(mapping_.scene_from_base) * handle * placement_of(mapping_.handle_from_tool);
}

plp_device_state Rig::device_state() const {
  plp_device_state state;
  plp_device_state_init(&state, sizeof state);
  check(plp_device_get_state(device_.get(), &state));
  return state;
}

plp_device_info Rig::device_info() const {
  plp_device_info info;
  plp_device_info_init(&info, sizeof info);
  check(plp_device_get_info(device_.get(), &info));
  return info;
}

plp_servo_state Rig::servo() const {
  plp_servo_state state;
  plp_servo_state_init(&state, sizeof state);
  check(plp_scene_get_servo(scene_.get(), &state));
  return state;
}

double Rig::seconds() const {
  const std::uint64_t ticks = has_device() ? device_state().ticks : steps_;
  return kTick * static_cast<double>(ticks);
}

plp_body Rig::add(const ModelFile& file, plp_body_options options, const Placement& placement) {
  options.model = file.model.get();
  options.pose = pose_of(placement);
  plp_body body = 0;
  check(plp_scene_add_body(scene_.get(), &options, &body));
  return body;
}

void Rig::give_to_device(const Content& content) {
  mapping_ = mapping_of(content);
  check(plp_device_open(content.arguments.device.c_str(), device_.receive()));
  plp_hand_options_init(&hand_, sizeof hand_);
  hand_.origin = pose_of(base_from_tool(content.place.start));
  const plp_result held = plp_device_set_hand(device_.get(), &hand_);
  simulated_ = held >= 0;
  if (!simulated_ && held != PLP_ERROR_UNSUPPORTED) check(held);
  if (simulated_) check(plp_device_place_in_hand(device_.get()));
  check(plp_scene_set_device(scene_.get(), device_.get(), &mapping_));
  arm(true);
}

Placement Rig::base_from_tool(const Placement& tool) const {
  const Placement handle = tool * inverse(placement_of(mapping_.handle_from_tool));
  Placement base = inverse(placement_of(mapping_.scene_from_base)) * handle;
  base.position /= mapping_.motion_scale;
  return base;
}

}  // namespace palpate::viewer
