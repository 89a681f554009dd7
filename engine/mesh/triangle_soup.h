#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/math/vector.h"

namespace palpate {

using TriangleIndices = std::array<std::uint32_t, 3>;

// Raw triangles as a loader or a caller gives them: nothing welded, nothing checked but the index range.
struct TriangleSoup {
  std::vector<DVec3> positions;            // metres, frame of the model
  std::vector<TriangleIndices> triangles;  // counter-clockwise seen from outside
  std::vector<bool> double_sided;          // one flag a triangle; empty: all are single-sided
};

}  // namespace palpate
