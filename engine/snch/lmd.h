#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/vector.h"
#include "engine/mesh/mesh.h"
#include "engine/snch/room.h"

namespace palpate {

// A local minimum distance between two models A and B, or one point of a plateau of equal ones. Metres, frame
// of A.
struct Lmd {
  DVec3 point_a;
  DVec3 point_b;
  DVec3 normal;  // unit vector from point_a to point_b
  double distance;
  double weight;      // the weights of one set sum to 1
  std::uint32_t set;  // points of one plateau share it
  Feature feature_a;
  Feature feature_b;
};

// A pair of features that holds a local minimum distance or almost does. Where others continue its features
// it may be found beyond their ends, too, on each of them.
struct NearMinimum : Lmd {
  double hold = 1.0;  // 1 on its own features, fading to 0 beyond their ends
};

// Two triangles, by their index in their meshes.
struct TrianglePair {
  std::uint32_t a;
  std::uint32_t b;

  friend auto operator<=>(const TrianglePair&, const TrianglePair&) = default;
};

// Work that a search did, to prove what was skipped.
struct SearchWork {
  std::uint64_t node_pairs = 0;      // visited
  std::uint64_t triangle_pairs = 0;  // tested
};

// The complete set of local minimum distances between two models within the cutoff.
struct LmdSet {
  std::vector<Lmd> lmds;                 // ordered by set, then by features
  std::uint32_t set_count = 0;           // a plateau counts once
  std::vector<NearMinimum> near_minima;  // if asked for: each its own set, its weight before it is shared
  std::vector<TrianglePair> overlaps;    // triangles that touch or cross, up to a limit
  bool overlaps_cut = false;             // there are more than the limit
  bool cut = false;                      // the search ran out of room: not all is here
  SearchWork work;

  bool overlapping() const { return overlaps_cut || !overlaps.empty(); }
  bool has_plateau() const { return lmds.size() > set_count; }
  void clear();
  void reserve(const Room& room);
  void add_overlap(TrianglePair pair, std::size_t limit);
};

// Take LMDs from the normalised frame of model A to metres.
Lmd in_metres(const ModelFrame& frame, Lmd lmd);
void to_metres(const ModelFrame& frame, LmdSet& found);

}  // namespace palpate
