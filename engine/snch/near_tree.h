#pragma once

#include "engine/mesh/creases.h"
#include "engine/snch/tree.h"

namespace palpate {

// The hierarchy for searches that ask for near minima, too: its cones are wider by the smoothing angle, and
// its triangles own what can hold a near minimum besides. Immutable.
struct NearTree {
  Creases creases;
  Tree tree;

  // Throws std::bad_alloc.
  explicit NearTree(const Mesh& mesh) : creases(mesh), tree(Tree::build(mesh, creases)) {}

  std::size_t bytes() const { return creases.bytes() + tree.bytes(); }
};

}  // namespace palpate
