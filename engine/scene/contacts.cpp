#include "engine/scene/contacts.h"

#include <algorithm>

#include "engine/snch/plateau.h"

namespace palpate {
namespace {

// Which of a triangle's three `items` is `wanted`; it is one of them.
std::uint8_t corner_of(const TriangleIndices& items, std::uint32_t wanted) {
  return static_cast<std::uint8_t>(std::find(items.begin(), items.end(), wanted) - items.begin());
}

SurfacePlace place_of(const Mesh& mesh, const Feature& feature) {
  switch (feature.kind) {
    case FeatureKind::kEdge: {
      const std::uint32_t owner = mesh.owner_of_edge(feature.index);
      return {feature.kind, corner_of(mesh.triangle_edges[owner], feature.index), mesh.source[owner]};
    }
    case FeatureKind::kVertex: {
      const std::uint32_t owner = mesh.owner_of_vertex(feature.index);
      return {feature.kind, corner_of(mesh.triangles[owner], feature.index), mesh.source[owner]};
    }
    case FeatureKind::kFace:
      break;
  }
  return {FeatureKind::kFace, 0, mesh.source[feature.index]};
}

void append_overlaps(const LmdSet& found, const ContactPair& pair, Contacts& contacts) {
  contacts.overlap |= found.overlapping();
  contacts.overlaps_cut |= found.overlaps_cut;
  for (const TrianglePair& triangles : found.overlaps) {
    if (contacts.overlaps.size() >= pair.max_overlaps) {
      contacts.overlaps_cut = true;
      return;
    }
    contacts.overlaps.push_back(
        {pair.body_id, pair.tool_id, {pair.body.source[triangles.a], pair.tool.source[triangles.b]}});
  }
}

}  // namespace

void ContactWork::add(const PairWork& pair) {
  coherence.descents += pair.descents;
  coherence.descent_steps += pair.descent_steps;
  coherence.front_entries += pair.front_entries;
  coherence.front_expired += pair.front_expired;
  coherence.rebuilds += pair.rebuilds;
  coherence.age = std::max(coherence.age, pair.age);
  coherence.global_us += pair.global_us;
}

void Contacts::clear() {
  lmds.clear();
  springs.clear();
  set_count = 0;
  overlaps.clear();
  overlap = false;
  overlaps_cut = false;
  min_distance = std::numeric_limits<double>::infinity();
  wrench = {};
  work = {};
  search_us = 0.0;
  status = 0;
  step = 0;
}

void Contacts::fix(const Most& most) {
  most_lmds_ = most.lmds;
  most_springs_ = most.springs;
  lmds.reserve(most.lmds);
  springs.reserve(most.springs);
  overlaps.reserve(most.overlaps);
}

void Contacts::unfix() {
  most_lmds_ = most_springs_ = kAny;
}

bool Contacts::has_room_for_set() const {
  return lmds.size() + PlateauGrouper::kMaxPoints <= most_lmds_;
}

Contact contact_of(const Lmd& lmd, const ContactPair& pair, std::uint32_t first_set) {
  Contact contact;
  contact.point_a = pair.world_from_body * lmd.point_a;
  contact.point_b = pair.world_from_body * lmd.point_b;
  contact.normal = pair.world_from_body.rotation * lmd.normal;
  contact.distance = lmd.distance;
  contact.weight = lmd.weight;
  contact.force = spring_force({contact.point_b, contact.normal, lmd.distance, lmd.weight}, pair.law);
  contact.body_a = pair.body_id;
  contact.body_b = pair.tool_id;
  contact.set = first_set + lmd.set;
  contact.place_a = place_of(pair.body, lmd.feature_a);
  contact.place_b = place_of(pair.tool, lmd.feature_b);
  return contact;
}

void append_contacts(const LmdSet& found, const ContactPair& pair, Contacts& contacts) {
  bool listed = true;
  for (std::size_t i = 0; i < found.lmds.size(); ++i) {
    const Lmd& lmd = found.lmds[i];
    if (i == 0 || lmd.set != found.lmds[i - 1].set) listed = contacts.has_room_for_set();
    const Contact contact = contact_of(lmd, pair, contacts.set_count);
    contacts.min_distance = std::min(contacts.min_distance, contact.distance);
    if (listed) {
      contacts.lmds.push_back(contact);
    } else {
      contacts.status |= kStatusCut;
    }
  }
  if (found.cut) contacts.status |= kStatusCut;
  contacts.set_count += found.set_count;
  append_overlaps(found, pair, contacts);
}

}  // namespace palpate
