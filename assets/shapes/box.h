#pragma once

#include <array>

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

using Divisions = std::array<int, 3>;

// A box around the origin whose faces are cut into cells of two triangles: 4·(xy + yz + zx) triangles.
TriangleSoup box(const DVec3& size, const Divisions& divisions = {1, 1, 1});

// A thin box, finely cut in its plane: one contact plateau made of many triangles.
TriangleSoup plate(int divisions = 24);

// Two boxes of different depth side by side: they touch in a plane, and their upper faces are one plane.
TriangleSoup flush_boxes();

}  // namespace palpate::shapes
