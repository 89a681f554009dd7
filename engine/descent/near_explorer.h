#pragma once

#include <vector>

#include "engine/math/pose.h"
#include "engine/snch/lmd.h"
#include "engine/snch/model.h"

namespace palpate {

// Finds the near minima around LMDs that are followed by descent: those that pairs of neighbouring triangles
// connect with one. It misses what is connected with none. The cost is that of the near minima. Keeps its
// memory from call to call.
class NearExplorer {
 public:
  // Fills found.near_minima with those within `cutoff` (metres) around found.lmds, which are those at this
  // pose, and adds to its work.
  void explore(const Model& a, const Model& b, const Pose& a_from_b, double cutoff, LmdSet& found);

  // From now on nothing is allocated, and what finds no room is cut, and flagged.
  void fix();
  void unfix() { fixed_ = false; }

 private:
  void open_around(const Mesh& a, const Mesh& b, const Lmd& minimum, LmdSet& found);
  void keep_unexplored();
  void mark_explored();

  bool fixed_ = false;
  std::vector<TrianglePair> open_;      // to be tested next
  std::vector<TrianglePair> explored_;  // ascending
  std::vector<TrianglePair> merged_;
};

}  // namespace palpate
