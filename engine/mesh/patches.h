#pragma once

#include "engine/mesh/edge_uses.h"

namespace palpate {

// A surface cut into patches: triangles that are joined through edges of exactly two triangles.
struct Patches {
  Groups<std::uint32_t> triangles;         // by patch, breadth first from its lowest triangle
  std::vector<std::uint32_t> of_triangle;  // the patch of each triangle
  std::vector<bool> turned;  // whether a triangle must be reversed to be wound as the first one of its patch
  std::uint64_t one_sided =
      0;  // patches that cannot be wound consistently; none of their triangles is `turned`
};

Patches patches_of(const EdgeUses& edges, std::size_t triangle_count);

}  // namespace palpate
