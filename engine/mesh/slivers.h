#pragma once

#include "engine/mesh/clean_triangles.h"

namespace palpate {

// A sliver is a triangle of zero area with three different corners a, b, c, where b lies between a and c. It
// is what joins two sides of a surface that are cut differently: edge ac on one side, ab and bc on the other.
// This splits the triangle across ac at b, after which both sides fit without the sliver. Repeats until no
// sliver can be resolved so, because its longest edge has no other triangle or several. `slivers` is
// ascending. Slivers, resolved or not, stay in `surface`. Returns the number of triangles with area that it
// split.
std::uint64_t split_beside_slivers(CleanTriangles& surface, const std::vector<std::uint32_t>& slivers);

}  // namespace palpate
