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

// The set of a spring that is no LMD of this moment.
inline constexpr std::uint32_t kNoSet = 0xffffffffu;

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
  kStatusCut = 2,        // more than there was room for
  kStatusWaiting = 4,    // a near model is still being prepared
  kStatusWall = 8,       // surfaces overlap and walls hold the tool
};

// All that the tool meets at one moment.
struct Contacts {
  std::vector<Contact> lmds;     // ordered by set; each with the force of its spring alone
  std::vector<Contact> springs;  // all that pushes, each with its whole force
  std::uint32_t set_count = 0;
  std::vector<BodyOverlap> overlaps;
  bool overlap = false;
  bool overlaps_cut = false;  // more overlap than are listed
  double min_distance = std::numeric_limits<double>::infinity();
  Wrench wrench;  // of the springs on the tool about its reference point
  ContactWork work;
  double search_us = 0.0;
  std::uint32_t status = 0;  // of ContactStatus
  std::uint64_t step = 0;    // counts from 1

  void clear();  // keeps the memory
  bool walled() const { return (status & kStatusWall) != 0; }

  // What is listed at most once memory is fixed. LMDs that are not listed push all the same; springs beyond
  // do not. Either is flagged.
  struct Most {
    std::size_t lmds;
    std::size_t springs;
    std::size_t overlaps;
  };
  void fix(const Most& most);  // from now on nothing is allocated
  void unfix();
  bool has_room_for_set() const;
  bool has_room_for_spring() const { return springs.size() < most_springs_; }

 private:
  static constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();

  std::size_t most_lmds_ = kAny;
  std::size_t most_springs_ = kAny;
};

// What turns the LMDs of one pair of models into contacts.
struct ContactPair {
  const Mesh& body;
  const Mesh& tool;
  BodyId body_id;
  BodyId tool_id;
  Pose world_from_body;
  SpringLaw law;
  std::size_t max_overlaps;
};

// An LMD of `pair` in the world's frame with the force of its spring alone. `first_set` is what its set 0 is
// called.
Contact contact_of(const Lmd& lmd, const ContactPair& pair, std::uint32_t first_set);

// Adds what a search of `pair` found; not what pushes.
void append_contacts(const LmdSet& found, const ContactPair& pair, Contacts& contacts);

}  // namespace palpate
