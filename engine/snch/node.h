#pragma once

#include <cstdint>

#include "engine/math/vector.h"

namespace palpate {

// A node of a spatialized normal cone hierarchy [JC01]: bounds of its triangles and of all directions in
// which a local minimum distance can leave them, that is, the outward polar cones of the faces, edges and
// vertices that its triangles own. All bounds are rounded outward. Normalised frame of the model.
struct Node {
  Vec3 centre;  // of box and sphere
  float radius;
  Vec3 half;          // of the box
  float cone_cosine;  // negative: the cone is whole
  Vec3 cone_axis;
  float cone_sine;
  std::uint32_t link;  // inner node: its second child, the first one follows it; leaf: kLeaf | triangle

  static constexpr std::uint32_t kLeaf = 1u << 31;
  bool is_leaf() const { return (link & kLeaf) != 0; }
  std::uint32_t triangle() const { return link & ~kLeaf; }
  std::uint32_t second_child() const { return link; }
};

}  // namespace palpate
