#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/math/box.h"
#include "engine/mesh/triangle_soup.h"

namespace palpate {

// A closed component of a surface.
struct Shell {
  std::span<const std::uint32_t> triangles;
  Box box;
  double volume = 0;  // six times what it encloses, negative if it faces inward
};

constexpr std::uint32_t kNoShell = std::numeric_limits<std::uint32_t>::max();

// For each shell the innermost other one that contains it, or kNoShell. `shells` come in descending order of
// |volume|, so a shell lies after the one that contains it. Shells should not intersect: of one that does,
// the centre of its first triangle decides.
std::vector<std::uint32_t> enclosing_shells(const std::vector<Vec3>& positions,
                                            const std::vector<TriangleIndices>& triangles,
                                            const std::vector<Shell>& shells);

}  // namespace palpate
