#include "capi/src/contact_arrays.h"

#include <limits>

namespace palpate::capi {
namespace {

static_assert(static_cast<int>(FeatureKind::kFace) == PLP_FEATURE_FACE);
static_assert(static_cast<int>(FeatureKind::kEdge) == PLP_FEATURE_EDGE);
static_assert(static_cast<int>(FeatureKind::kVertex) == PLP_FEATURE_VERTEX);
static_assert(static_cast<int>(kStatusCut) == PLP_STATUS_CUT);
static_assert(static_cast<int>(kStatusWaiting) == PLP_STATUS_WAITING);

plp_lmd lmd_of(const Contact& contact, const Space& space) {
  plp_lmd lmd;
  space.point_out(contact.point_a, lmd.point_a);
  space.point_out(contact.point_b, lmd.point_b);
  space.direction_out(contact.normal, lmd.normal);
  lmd.distance = space.length_out(contact.distance);
  lmd.weight = contact.weight;
  space.direction_out(contact.force, lmd.force);
  lmd.body_a = contact.body_a;
  lmd.body_b = contact.body_b;
  lmd.set = contact.set;
  lmd.feature_a = static_cast<std::uint8_t>(contact.place_a.kind);
  lmd.feature_b = static_cast<std::uint8_t>(contact.place_b.kind);
  lmd.corner_a = contact.place_a.corner;
  lmd.corner_b = contact.place_b.corner;
  lmd.triangle_a = contact.place_a.triangle;
  lmd.triangle_b = contact.place_b.triangle;
  return lmd;
}

plp_overlap overlap_of(const BodyOverlap& overlap) {
  return {overlap.body_a, overlap.body_b, overlap.triangles.a, overlap.triangles.b};
}

static_assert(static_cast<int>(kStatusByDescent) == PLP_STATUS_BY_DESCENT);

plp_work work_of(const ContactWork& work) {
  const PairWork& coherence = work.coherence;
  return {work.bodies,        work.body_pairs,         work.search.node_pairs,  work.search.triangle_pairs,
          coherence.descents, coherence.descent_steps, coherence.front_entries, coherence.front_expired,
          coherence.age,      coherence.global_us,     coherence.rebuilds};
}

}  // namespace

void ContactArrays::assign(const Contacts& contacts, const Space& space) {
  // Only these can throw.
  lmds_.reserve(contacts.lmds.size());
  springs_.reserve(contacts.springs.size());
  overlaps_.reserve(contacts.overlaps.size());

  clear();
  for (const Contact& contact : contacts.lmds) lmds_.push_back(lmd_of(contact, space));
  for (const Contact& spring : contacts.springs) springs_.push_back(lmd_of(spring, space));
  for (const BodyOverlap& overlap : contacts.overlaps) overlaps_.push_back(overlap_of(overlap));
  shown_.overlap = contacts.overlap;
  shown_.lmds = lmds_.data();
  shown_.lmd_count = lmds_.size();
  shown_.set_count = contacts.set_count;
  shown_.overlaps = overlaps_.data();
  shown_.overlap_count = overlaps_.size();
  shown_.overlaps_cut = contacts.overlaps_cut;
  shown_.min_distance = space.length_out(contacts.min_distance);
  shown_.wrench = space.wrench_out(contacts.wrench);
  shown_.search_us = contacts.search_us;
  shown_.work = work_of(contacts.work);
  shown_.springs = springs_.data();
  shown_.spring_count = springs_.size();
  shown_.status = contacts.status;
}

void ContactArrays::clear() {
  lmds_.clear();
  springs_.clear();
  overlaps_.clear();
  shown_ = {};
  shown_.lmd_stride = sizeof(plp_lmd);
  shown_.overlap_stride = sizeof(plp_overlap);
  shown_.min_distance = std::numeric_limits<double>::infinity();
}

}  // namespace palpate::capi
