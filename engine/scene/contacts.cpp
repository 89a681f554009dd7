#include "engine/scene/contacts.h"

#include <algorithm>
#include <span>

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

Contact contact_of(const Lmd& lmd, double weight, const ContactPair& pair, std::uint32_t first_set) {
  Contact contact;
  contact.point_a = pair.world_from_body * lmd.point_a;
  contact.point_b = pair.world_from_body * lmd.point_b;
  contact.normal = pair.world_from_body.rotation * lmd.normal;
  contact.distance = lmd.distance;
  contact.weight = weight;
  contact.force = spring_force({contact.point_b, contact.normal, lmd.distance, weight}, pair.law);
  contact.body_a = pair.body_id;
  contact.body_b = pair.tool_id;
  contact.set = first_set + lmd.set;
  contact.place_a = place_of(pair.body, lmd.feature_a);
  contact.place_b = place_of(pair.tool, lmd.feature_b);
  return contact;
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

bool same_place(const SurfacePlace& one, const SurfacePlace& other) {
  return one.kind == other.kind && one.corner == other.corner && one.triangle == other.triangle;
}

// An LMD has the force of the spring on its own two features; the others only hand over to it.
void lend_forces(std::span<const Contact> springs, std::span<Contact> lmds) {
  for (Contact& lmd : lmds) {
    const auto own = std::find_if(springs.begin(), springs.end(), [&](const Contact& spring) {
      return same_place(spring.place_a, lmd.place_a) && same_place(spring.place_b, lmd.place_b);
    });
    lmd.force = own == springs.end() ? DVec3(0.0) : own->force;
  }
}

}  // namespace

void ContactWork::add(const PairWork& pair) {
  coherence.descents += pair.descents;
  coherence.descent_steps += pair.descent_steps;
  coherence.front_entries += pair.front_entries;
  coherence.front_expired += pair.front_expired;
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
}

void ContactMaker::append(const LmdSet& found, const ContactPair& pair, Contacts& contacts) {
  const std::size_t first_lmd = contacts.lmds.size(), first_spring = contacts.springs.size();
  for (const Lmd& lmd : found.lmds) {
    contacts.lmds.push_back(contact_of(lmd, lmd.weight, pair, contacts.set_count));
    contacts.min_distance = std::min(contacts.min_distance, lmd.distance);
  }
  contacts.set_count += found.set_count;
  const auto lmds = contacts.lmds.begin() + static_cast<std::ptrdiff_t>(first_lmd);
  if (pair.force_law == ForceLaw::kSmooth) {
    append_near_minima(found, pair, contacts);
    lend_forces(
        {contacts.springs.begin() + static_cast<std::ptrdiff_t>(first_spring), contacts.springs.end()},
        {lmds, contacts.lmds.end()});
  } else {
    contacts.springs.insert(contacts.springs.end(), lmds, contacts.lmds.end());
  }
  for (std::size_t i = first_spring; i < contacts.springs.size(); ++i)
    contacts.wrench += wrench_about(pair.reference, contacts.springs[i].point_b, contacts.springs[i].force);
  append_overlaps(found, pair, contacts);
}

void ContactMaker::append_near_minima(const LmdSet& found, const ContactPair& pair, Contacts& contacts) {
  near_.clear();
  for (const Lmd& near : found.near_minima)
    near_.push_back({near.point_a, near.point_b, near.normal, near.distance, near.weight});
  const std::span<const double> factors = smooth_law_.share(near_, pair.law.cutoff);
  const auto first = static_cast<std::uint32_t>(contacts.springs.size());
  for (std::size_t i = 0; i < factors.size(); ++i)
    contacts.springs.push_back(contact_of(found.near_minima[i], factors[i], pair, first));
}

}  // namespace palpate
