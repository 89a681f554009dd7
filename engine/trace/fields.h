#pragma once

#include "engine/trace/records.h"

namespace palpate {

// The order of every record in a file, told once: to whoever writes, reads or measures. See FORMAT.md.

template <class Visit>
void each_field(TracePose& pose, Visit&& visit) {
  visit(pose.rotation);
  visit(pose.translation);
}

template <class Visit>
void each_field(TraceSettings& settings, Visit&& visit) {
  visit(settings.cutoff);
  visit(settings.stiffness);
  visit(settings.damping);
  visit(settings.stiffness_cap);
  visit(settings.friction);
  visit(settings.mode);
  visit(settings.law);
}

template <class Visit>
void each_field(TraceHeader& header, Visit&& visit) {
  visit(header.space.axes);
  visit(header.space.metres_per_unit);
  each_field(header.settings, visit);
  visit(header.global_every);
  visit(header.tick_budget);
  visit(header.max_overlaps);
  visit(header.fade_time);
  visit(header.time_step);
}

// All but the name, which follows.
template <class Visit>
void each_field(TraceBody& body, Visit&& visit) {
  visit(body.id);
  visit(body.kind);
  visit(body.intangible);
  visit(body.triangles);
  visit(body.hash);
  visit(body.stiffness);
  visit(body.damping);
  visit(body.friction);
  visit(body.reference_point);
}

template <class Visit>
void each_field(TraceWork& work, Visit&& visit) {
  visit(work.bodies);
  visit(work.body_pairs);
  visit(work.node_pairs);
  visit(work.triangle_pairs);
  visit(work.descents);
  visit(work.descent_steps);
  visit(work.front_entries);
  visit(work.front_expired);
  visit(work.age);
  visit(work.rebuilds);
  visit(work.global_us);
}

template <class Visit>
void each_field(TraceTick& tick, Visit&& visit) {
  visit(tick.step);
  visit(tick.clock);
  visit(tick.time_step);
  visit(tick.lost);
  visit(tick.tool);
  each_field(tick.tool_pose, visit);
  visit(tick.force);
  visit(tick.torque);
  visit(tick.min_distance);
  visit(tick.step_us);
  each_field(tick.work, visit);
  visit(tick.status);
  visit(tick.overlap);
  visit(tick.overlap_count);
  visit(tick.set_count);
  visit(tick.settings_count);
  visit(tick.removed_count);
  visit(tick.pose_count);
  visit(tick.contact_count);
}

template <class Visit>
void each_field(TraceRemoval& removal, Visit&& visit) {
  visit(removal.body);
}

template <class Visit>
void each_field(TraceMove& move, Visit&& visit) {
  visit(move.body);
  each_field(move.pose, visit);
}

template <class Visit>
void each_field(TraceContact& contact, Visit&& visit) {
  visit(contact.point_a);
  visit(contact.point_b);
  visit(contact.normal);
  visit(contact.distance);
  visit(contact.weight);
  visit(contact.force);
  visit(contact.body_a);
  visit(contact.body_b);
  visit(contact.set);
  visit(contact.feature);
  visit(contact.corner);
  visit(contact.triangle);
}

template <class Visit>
void each_field(TraceEnd& end, Visit&& visit) {
  visit(end.ticks);
  visit(end.lost);
}

}  // namespace palpate
