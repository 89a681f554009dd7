#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "tests/fuzz/box_model.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/sound.h"
#include "tests/fuzz/targets.h"

namespace palpate::fuzz {
namespace {

constexpr std::uint64_t kMostReplayed = 16;  // steps
constexpr std::uint64_t kMostBodies = 64;

bool finite(const plp_pose& pose) {
  const auto number = [](double x) { return std::isfinite(x); };
  return std::all_of(pose.position, pose.position + 3, number) &&
         std::all_of(pose.orientation, pose.orientation + 4, number);
}

// What is read of a step is sound, whatever the file holds.
void require_sound_step(plp_trace trace, const plp_trace_tick& tick) {
  require(finite(tick.tool_pose), "a finite pose of the tool");
  for (std::size_t i = 0; i < tick.move_count; ++i) require(finite(tick.moves[i].pose), "a finite move");
  for (std::size_t i = 0; i < tick.removed_count; ++i)
    require(tick.removed[i] != 0, "a body that was removed");
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  require(checked(plp_trace_get_contacts(trace, &contacts)) == PLP_OK, "contacts of a step");
  for (std::size_t i = 0; i < contacts.lmd_count; ++i)
    require(std::isfinite(contacts.lmds[i].distance) && contacts.lmds[i].feature_a <= PLP_FEATURE_VERTEX &&
                contacts.lmds[i].feature_b <= PLP_FEATURE_VERTEX,
            "a sound LMD");
}

void read_all(plp_trace trace, const plp_trace_info& info) {
  for (std::uint64_t i = 0; i < info.ticks; ++i) {
    plp_trace_tick tick;
    plp_trace_tick_init(&tick, sizeof tick);
    if (checked(plp_trace_read(trace, i, &tick)) == PLP_OK) require_sound_step(trace, tick);
  }
  plp_trace_tick behind;
  plp_trace_tick_init(&behind, sizeof behind);
  require(checked(plp_trace_read(trace, info.ticks, &behind)) == PLP_ERROR_INVALID_ARGUMENT,
          "an error behind the last step");
}

// A scene as the trace's, of boxes, at which its motion is played.
class Replay {
 public:
  Replay(plp_trace trace, const plp_trace_info& info) : trace_(trace), box_(box_model(1.0f)) {
    plp_scene_options options;
    plp_scene_options_init(&options, sizeof options);
    require(checked(plp_trace_get_options(trace, &options)) == PLP_OK, "options of a trace");
    require(checked(plp_scene_create(&options, &scene_)) == PLP_OK, "a scene by the options of a trace");
    cutoff_ = options.cutoff;
    for (std::uint64_t i = 0; i < std::min(info.bodies, kMostBodies); ++i) add(i);
  }
  ~Replay() {
    plp_scene_release(scene_);
    plp_model_release(box_);
  }
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;

  void step(std::uint64_t index) {
    for (const auto& [recorded, body] : bodies_)
      checked(plp_trace_place(trace_, index, recorded, scene_, body));
    fuzz::step(scene_, cutoff_);
  }

 private:
  void add(std::uint64_t index) {
    plp_trace_body traced;
    plp_trace_body_init(&traced, sizeof traced);
    require(checked(plp_trace_get_body(trace_, index, &traced)) == PLP_OK, "a body of a trace");
    require(std::strlen(traced.model_name) <= 255, "a name of at most 255 bytes");
    plp_body_options options;
    plp_body_options_init(&options, sizeof options);
    options.model = box_;
    options.kind = static_cast<plp_body_kind>(traced.kind);
    options.stiffness = traced.stiffness;
    options.damping = traced.damping;
    options.friction = traced.friction;
    options.intangible = traced.intangible;
    std::copy_n(traced.reference_point, 3, options.reference_point);
    plp_body body = 0;
    if (checked(plp_scene_add_body(scene_, &options, &body)) == PLP_OK) bodies_[traced.body] = body;
  }

  plp_trace trace_;
  plp_model box_;
  plp_scene scene_ = nullptr;
  double cutoff_ = 0.0;
  std::map<plp_body, plp_body> bodies_;  // by the trace's
};

}  // namespace

void trace(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(bytes);
  plp_trace opened = nullptr;
  if (checked(plp_trace_open(file.path().c_str(), &opened)) < 0) {
    require(!opened, "no trace after an error");
    return;
  }
  plp_trace_info info;
  plp_trace_info_init(&info, sizeof info);
  require(checked(plp_trace_get_info(opened, &info)) == PLP_OK, "an info of a trace");
  require(info.bytes <= bytes.size(), "no more bytes than there are");
  read_all(opened, info);
  {
    Replay replay(opened, info);
    for (std::uint64_t i = 0; i < std::min(info.ticks, kMostReplayed); ++i) replay.step(i);
  }
  require(checked(plp_trace_release(opened)) == PLP_OK, "a trace to release");
}

}  // namespace palpate::fuzz
