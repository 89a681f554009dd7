#include "engine/runtime/trace_records.h"

#include "engine/mesh/geometry_hash.h"

namespace palpate {
namespace {

static_assert(static_cast<int>(SearchMode::kGlobal) == 0 && static_cast<int>(SearchMode::kCertified) == 2);
static_assert(static_cast<int>(ForceLaw::kSprings) == 0 && static_cast<int>(ForceLaw::kSmooth) == 1);
static_assert(static_cast<int>(BodyKind::kStatic) == 0 && static_cast<int>(BodyKind::kTool) == 2);
static_assert(static_cast<int>(FeatureKind::kFace) == 0 && static_cast<int>(FeatureKind::kVertex) == 2);

TraceWork trace_of(const ContactWork& work) {
  TraceWork traced;
  traced.bodies = work.bodies;
  traced.body_pairs = work.body_pairs;
  traced.node_pairs = work.search.node_pairs;
  traced.triangle_pairs = work.search.triangle_pairs;
  traced.descents = work.coherence.descents;
  traced.descent_steps = work.coherence.descent_steps;
  traced.front_entries = work.coherence.front_entries;
  traced.front_expired = work.coherence.front_expired;
  traced.age = work.coherence.age;
  traced.rebuilds = work.coherence.rebuilds;
  traced.global_us = work.coherence.global_us;
  return traced;
}

ContactWork work_from(const TraceWork& traced) {
  ContactWork work;
  work.bodies = traced.bodies;
  work.body_pairs = traced.body_pairs;
  work.search.node_pairs = traced.node_pairs;
  work.search.triangle_pairs = traced.triangle_pairs;
  work.coherence.descents = traced.descents;
  work.coherence.descent_steps = traced.descent_steps;
  work.coherence.front_entries = traced.front_entries;
  work.coherence.front_expired = traced.front_expired;
  work.coherence.age = static_cast<unsigned>(traced.age);
  work.coherence.rebuilds = traced.rebuilds;
  work.coherence.global_us = traced.global_us;
  return work;
}

SurfacePlace place_from(const TraceContact& contact, int side) {
  return {static_cast<FeatureKind>(contact.feature[side]), contact.corner[side], contact.triangle[side]};
}

Contact contact_from(const TraceContact& contact) {
  Contact found;
  found.point_a = vector_from(contact.point_a);
  found.point_b = vector_from(contact.point_b);
  found.normal = vector_from(contact.normal);
  found.distance = contact.distance;
  found.weight = contact.weight;
  found.force = vector_from(contact.force);
  found.body_a = contact.body_a;
  found.body_b = contact.body_b;
  found.set = contact.set;
  found.place_a = place_from(contact, 0);
  found.place_b = place_from(contact, 1);
  return found;
}

TraceSettings trace_settings(const SceneOptions& options) {
  return {options.cutoff,
          options.stiffness,
          options.damping,
          options.stiffness_cap,
          options.friction,
          static_cast<std::uint32_t>(options.mode),
          static_cast<std::uint32_t>(options.law)};
}

}  // namespace

TraceVector trace_of(const DVec3& vector) {
  return {vector.x, vector.y, vector.z};
}

TracePose trace_of(const Pose& pose) {
  TracePose traced;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) traced.rotation[3 * column + row] = pose.rotation[column][row];
  traced.translation = trace_of(pose.translation);
  return traced;
}

// The cap may be the device's, which is not there when a trace is replayed.
TraceSettings trace_settings(const Scene& scene) {
  TraceSettings settings = trace_settings(scene.options());
  settings.stiffness_cap = scene.stiffness_cap();
  return settings;
}

TraceHeader trace_of(const SceneOptions& options, const TraceSpace& space) {
  TraceHeader header;
  header.space = space;
  header.settings = trace_settings(options);
  header.global_every = options.global_every;
  header.tick_budget = options.tick_budget;
  header.max_overlaps = options.max_overlaps;
  header.fade_time = options.fade_time;
  header.time_step = options.time_step;
  return header;
}

TraceBody trace_of(BodyId id, const BodyOptions& options) {
  TraceBody body;
  body.id = id;
  body.kind = static_cast<std::uint32_t>(options.kind);
  body.intangible = options.intangible ? 1 : 0;
  body.triangles = options.model->mesh().triangles.size();
  body.hash = geometry_hash(options.model->mesh());
  body.stiffness = options.stiffness;
  body.damping = options.damping;
  body.friction = options.friction;
  body.reference_point = trace_of(options.reference_point);
  body.name = options.model_name;
  return body;
}

TraceContact trace_of(const Contact& contact) {
  TraceContact traced;
  traced.point_a = trace_of(contact.point_a);
  traced.point_b = trace_of(contact.point_b);
  traced.normal = trace_of(contact.normal);
  traced.distance = contact.distance;
  traced.weight = contact.weight;
  traced.force = trace_of(contact.force);
  traced.body_a = contact.body_a;
  traced.body_b = contact.body_b;
  traced.set = contact.set;
  traced.feature = {static_cast<std::uint8_t>(contact.place_a.kind),
                    static_cast<std::uint8_t>(contact.place_b.kind)};
  traced.corner = {contact.place_a.corner, contact.place_b.corner};
  traced.triangle = {contact.place_a.triangle, contact.place_b.triangle};
  return traced;
}

TraceTick trace_of(const Contacts& contacts) {
  TraceTick tick;
  tick.step = contacts.step;
  tick.force = trace_of(contacts.wrench.force);
  tick.torque = trace_of(contacts.wrench.torque);
  tick.min_distance = contacts.min_distance;
  tick.step_us = contacts.search_us;
  tick.work = trace_of(contacts.work);
  tick.status = contacts.status;
  tick.overlap = contacts.overlap ? 1 : 0;
  tick.overlap_count = static_cast<std::uint32_t>(contacts.overlaps.size());
  tick.set_count = contacts.set_count;
  tick.contact_count = static_cast<std::uint32_t>(contacts.lmds.size());
  return tick;
}

DVec3 vector_from(const TraceVector& vector) {
  return {vector[0], vector[1], vector[2]};
}

Pose pose_from(const TracePose& pose) {
  Pose found;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) found.rotation[column][row] = pose.rotation[3 * column + row];
  found.translation = vector_from(pose.translation);
  return found;
}

void fill_from(const TraceStep& step, Contacts& contacts) {
  const TraceTick& tick = step.tick;
  contacts.clear();
  for (const TraceContact& contact : step.contacts) contacts.lmds.push_back(contact_from(contact));
  contacts.set_count = tick.set_count;
  contacts.overlap = tick.overlap != 0;
  contacts.overlaps_cut = tick.overlap_count > 0;
  contacts.min_distance = tick.min_distance;
  contacts.wrench = {vector_from(tick.force), vector_from(tick.torque)};
  contacts.work = work_from(tick.work);
  contacts.search_us = tick.step_us;
  contacts.status = tick.status;
  contacts.step = tick.step;
}

}  // namespace palpate
