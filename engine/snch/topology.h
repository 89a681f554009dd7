#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.h"

namespace palpate {

// The bare shape of a binary hierarchy in depth-first order: parents before children, a first child right
// after its parent. `link` is as in Node; `end` is one past the last node of the subtree.
struct TopologyNode {
  std::uint32_t link;
  std::uint32_t end;
};

// Splits the triangles of a mesh into a hierarchy by the surface area heuristic, through Embree's BVH
// builder. Throws std::bad_alloc.
std::vector<TopologyNode> build_topology(const Mesh& mesh);

}  // namespace palpate
