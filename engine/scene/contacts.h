#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/contact/spring.h"
#include "engine/math/pose.h"
#include "engine/scene/pair_search.h"
#include "engine/snch/lmd.h"

namespace palpate {

using BodyId = std::uint64_t;  // 0: none

// A place on a model in the terms of its input.
struct SurfacePlace {
  FeatureKind kind;
  std::uint8_t corner;     // of the triangle: which vertex, or which edge; 0 for a face
  std::uint32_t triangle;  // one that holds the feature, as numbered in the soup
};

// A local minimum distance between a body (a) and the tool (b), or one point of a plateau. World frame.
struct Contact {
  DVec3 point_a;
  DVec3 point_b;
  DVec3 normal;  // unit vector from point_a to point_b
  double distance;
  double weight;
  DVec3 force;  // on the tool at point_b
  BodyId body_a;
  BodyId body_b;
  std::uint32_t set;
  SurfacePlace place_a;
  SurfacePlace place_b;
};

// Two triangles that touch or cross, as numbered in their soups.
struct BodyOverlap {
  BodyId body_a;
  BodyId body_b;
  TrianglePair triangles;
};

// Work of one step, to prove what was skipped.
struct ContactWork {
  std::uint64_t bodies = 0;      // bounding spheres tested against the tool's
  std::uint64_t body_pairs = 0;  // searched
  SearchWork search;
  PairWork coherence;  // sums over the pairs; the age is that of the oldest

  void add(const PairWork& pair);
};

// What is not as it should be, in bits.
enum ContactStatus : std::uint32_t {
  kStatusByDescent = 1,  // the budget of a step ran out, and descent completed it
};

// All that the tool meets at one moment.
struct Contacts {
  std::vector<Contact> lmds;  // ordered by set
  std::uint32_t set_count = 0;
  std::vector<BodyOverlap> overlaps;
  bool overlap = false;
  bool overlaps_cut = false;  // more overlap than are listed
  double min_distance = std::numeric_limits<double>::infinity();
  Wrench wrench;  // on the tool about its reference point
  ContactWork work;
  std::uint32_t status = 0;  // of ContactStatus
  double search_us = 0.0;

  void clear();  // keeps the memory
};

// What turns the LMDs of one pair of models into contacts.
struct ContactPair {
  const Mesh& body;
  const Mesh& tool;
  BodyId body_id;
  BodyId tool_id;
  Pose world_from_body;
  SpringLaw law;
  DVec3 reference;  // of the torque, world frame
  std::size_t max_overlaps;
};

// Adds what a search of `pair` found.
void append_contacts(const LmdSet& found, const ContactPair& pair, Contacts& contacts);

}  // namespace palpate
