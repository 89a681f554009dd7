#include <algorithm>
#include <cmath>
#include <limits>

#include "capi/src/handles.h"
#include "capi/src/structs.h"
#include "engine/runtime/trace_records.h"

namespace palpate::capi {
namespace {

static_assert(PLP_MODE_GLOBAL == static_cast<int>(SearchMode::kGlobal) &&
              PLP_MODE_DESCENT == static_cast<int>(SearchMode::kDescent) &&
              PLP_MODE_CERTIFIED == static_cast<int>(SearchMode::kCertified));
static_assert(PLP_LAW_SPRINGS == static_cast<int>(ForceLaw::kSprings) &&
              PLP_LAW_SMOOTH == static_cast<int>(ForceLaw::kSmooth));
static_assert(PLP_BODY_STATIC == static_cast<int>(BodyKind::kStatic) &&
              PLP_BODY_MOVING == static_cast<int>(BodyKind::kMoving) &&
              PLP_BODY_TOOL == static_cast<int>(BodyKind::kTool));

HandleTable<TraceObject>::Pin pin_trace(plp_trace trace) {
  return trace_table().pin(bits_of(trace));
}

plp_space space_of(const TraceSpace& traced) {
  plp_space space{};
  std::copy_n(traced.axes.begin(), 3, space.axes);
  space.metres_per_unit = traced.metres_per_unit;
  return space;
}

// A length that length_in() makes `metres` of, bit by bit, which a division alone may miss.
double given_length(const Space& space, double metres) {
  constexpr double kUp = std::numeric_limits<double>::infinity();
  const double near = space.length_out(metres);
  for (const double tried : {near, std::nextafter(near, -kUp), std::nextafter(near, kUp)})
    if (space.length_in(tried) == metres) return tried;
  return near;
}

void write_point(const Space& space, const TraceVector& point, double out[3]) {
  space.direction_out(vector_from(point), out);
  for (int i = 0; i < 3; ++i) out[i] = given_length(space, out[i]);
}

plp_trace_info info_of(const TraceReader& reader) {
  plp_trace_info info{};
  info.complete = reader.complete();
  info.ticks = reader.ticks();
  info.lost = reader.lost();
  info.bodies = reader.bodies().size();
  info.bytes = reader.whole_bytes();
  info.duration = reader.duration();
  return info;
}

// Those of `options` that a trace has.
void write_options(const TraceObject& trace, plp_scene_options& options) {
  const TraceHeader& header = trace.reader->header();
  options.max_overlaps = static_cast<std::uint32_t>(std::min<std::uint64_t>(header.max_overlaps, UINT32_MAX));
  options.space = space_of(header.space);
  options.cutoff = given_length(trace.space, header.settings.cutoff);
  options.stiffness = header.settings.stiffness;
  options.mode = static_cast<std::int32_t>(header.settings.mode);
  options.law = static_cast<std::int32_t>(header.settings.law);
  options.damping = header.settings.damping;
  options.stiffness_cap = header.settings.stiffness_cap;
  options.friction = header.settings.friction;
  options.global_every = header.global_every;
  options.fade_time = header.fade_time;
  options.time_step = trace.reader->first_time_step().value_or(header.time_step);
  options.tick_budget = header.tick_budget;
}

plp_trace_body body_of(const TracedBody& traced, const TraceObject& trace) {
  const std::uint64_t ticks = trace.reader->ticks();
  plp_trace_body body{};
  body.kind = static_cast<std::int32_t>(traced.body.kind);
  body.body = traced.body.id;
  body.model_name = traced.body.name.c_str();
  body.model_triangles = traced.body.triangles;
  body.model_hash = traced.body.hash;
  body.stiffness = traced.body.stiffness;
  body.damping = traced.body.damping;
  body.friction = traced.body.friction;
  write_point(trace.space, traced.body.reference_point, body.reference_point);
  body.intangible = static_cast<std::int32_t>(traced.body.intangible);
  body.first_tick = traced.first_tick.value_or(ticks);
  body.end_tick = traced.end_tick.value_or(ticks);
  return body;
}

// Brings what is shown of the step up to date.
void show_step(TraceObject& trace) {
  trace.moves.clear();
  for (const TraceMove& move : trace.step.moves)
    trace.moves.push_back({move.body, trace.space.pose_out(pose_from(move.pose))});
  fill_from(trace.step, trace.contacts);
  trace.arrays.assign(trace.contacts, trace.space);
}

void write_settings(const TraceObject& trace, plp_trace_tick& tick) {
  const TraceSettings& settings = trace.step.settings;
  tick.cutoff = given_length(trace.space, settings.cutoff);
  tick.stiffness = settings.stiffness;
  tick.damping = settings.damping;
  tick.stiffness_cap = settings.stiffness_cap;
  tick.friction = settings.friction;
  tick.mode = static_cast<std::int32_t>(settings.mode);
  tick.law = static_cast<std::int32_t>(settings.law);
}

plp_trace_tick tick_of(const TraceObject& trace) {
  const TraceTick& traced = trace.step.tick;
  const plp_contacts& contacts = trace.arrays.shown();
  plp_trace_tick tick{};
  tick.status = traced.status;
  tick.step = traced.step;
  tick.lost = traced.lost;
  tick.time = trace.step.time;
  tick.clock = traced.clock;
  tick.time_step = traced.time_step;
  write_settings(trace, tick);
  tick.tool = traced.tool;
  tick.tool_pose = trace.space.pose_out(pose_from(traced.tool_pose));
  tick.wrench = contacts.wrench;
  tick.min_distance = contacts.min_distance;
  tick.set_count = contacts.set_count;
  tick.lmd_count = contacts.lmd_count;
  tick.overlap_count = traced.overlap_count;
  tick.overlap = contacts.overlap;
  tick.step_us = traced.step_us;
  tick.moves = trace.moves.data();
  tick.move_count = trace.moves.size();
  tick.move_stride = sizeof(plp_trace_move);
  tick.removed = trace.step.removed.data();
  tick.removed_count = trace.step.removed.size();
  return tick;
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_trace_info_init(plp_trace_info* info, size_t size) {
  fill_struct(plp_trace_info{}, info, size);
}

void plp_trace_body_init(plp_trace_body* body, size_t size) {
  fill_struct(plp_trace_body{}, body, size);
}

void plp_trace_tick_init(plp_trace_tick* tick, size_t size) {
  fill_struct(plp_trace_tick{}, tick, size);
}

plp_result plp_trace_open(const char* path, plp_trace* trace) {
  return guarded([&] {
    require(path && *path, "path is null or empty");
    require(trace, "trace is null");
    std::unique_ptr<const TraceReader> reader = value_or_refuse(TraceReader::open(path));
    const plp_space space = space_of(reader->header().space);
    *trace = new_handle<plp_trace>(trace_table(), std::make_unique<TraceObject>(std::move(reader), space));
  });
}

plp_result plp_trace_release(plp_trace trace) {
  return guarded([&] { release_handle(trace_table(), trace, "trace"); });
}

plp_result plp_trace_get_info(plp_trace trace, plp_trace_info* info) {
  return guarded([&] {
    const auto object = pin_trace(trace);
    require_handle(object, "trace");
    write_struct(info_of(*object->reader), info, "info");
  });
}

plp_result plp_trace_get_options(plp_trace trace, plp_scene_options* options) {
  return guarded([&] {
    const auto object = pin_trace(trace);
    require_handle(object, "trace");
    plp_scene_options filled = read_struct(options, "options");
    write_options(*object, filled);
    write_struct(filled, options, "options");
  });
}

plp_result plp_trace_get_body(plp_trace trace, uint64_t index, plp_trace_body* body) {
  return guarded([&] {
    const auto object = pin_trace(trace);
    require_handle(object, "trace");
    const std::vector<TracedBody>& bodies = object->reader->bodies();
    require(index < bodies.size(), "index is not below the number of bodies");
    write_struct(body_of(bodies[index], *object), body, "body");
  });
}

plp_result plp_trace_read(plp_trace trace, uint64_t index, plp_trace_tick* tick) {
  return guarded([&] {
    const auto object = pin_trace(trace);
    require_handle(object, "trace");
    checked_size(tick, "tick");
    object->has_step = false;
    value_or_refuse(object->reader->read(index, object->step));
    show_step(*object);
    object->has_step = true;
    write_struct(tick_of(*object), tick, "tick");
  });
}

plp_result plp_trace_get_contacts(plp_trace trace, plp_contacts* contacts) {
  return guarded([&] {
    const auto object = pin_trace(trace);
    require_handle(object, "trace");
    checked_size(contacts, "contacts");
    if (!object->has_step) refuse(ErrorCode::kWrongState, "no step of the trace was read");
    write_struct(object->arrays.shown(), contacts, "contacts");
  });
}

plp_result plp_trace_place(plp_trace trace, uint64_t tick, plp_body recorded, plp_scene scene,
                           plp_body body) {
  return guarded([&] {
    const auto object = pin_trace(trace);
    require_handle(object, "trace");
    const auto placed = scene_table().pin(bits_of(scene));
    require_handle(placed, "scene");
    const TracePose pose = value_or_refuse(object->reader->pose_of(recorded, tick));
    if (!placed->scene.set_pose(body, pose_from(pose)))
      refuse(ErrorCode::kInvalidHandle, "body is none of this scene");
  });
}
