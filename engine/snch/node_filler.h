#pragma once

#include <vector>

#include "engine/snch/packed_node.h"
#include "engine/snch/polar_directions.h"
#include "engine/snch/topology.h"

namespace palpate {

// Gives the nodes of a hierarchy their bounds, from the leaves up: subtrees side by side, then what is above
// them. In depth-first order, so that a subtree of n leaves takes 2 n − 1 nodes. With creases the cones bound
// near minima, too.
class NodeFiller {
 public:
  NodeFiller(const Mesh& mesh, const Creases* creases, std::vector<PackedNode>& nodes);

  void fill(const Topology& topology);

 private:
  using Branch = Topology::Branch;

  // What is above a subtree needs to know of it: its bounds before they were rounded.
  struct Bounds {
    Box box;
    Cone cone;
  };

  struct Subtree {
    Branch branch;
    std::uint32_t index;
    Bounds bounds;
  };

  class SubtreeFiller;

  static void collect(Branch branch, std::uint32_t index, std::vector<Subtree>& subtrees);
  Bounds fill_above(Branch branch, std::uint32_t index, const Subtree*& next);

  const Mesh& mesh_;
  const PolarDirections directions_;
  const double cone_margin_;  // the tangent of its half
  std::vector<PackedNode>& nodes_;
};

}  // namespace palpate
