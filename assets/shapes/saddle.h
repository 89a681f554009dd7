#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// A block bent into the hyperbolic paraboloid x² − y²: saddle vertices all over both large faces, one of them
// at the middle. 4·n·(n + 2) triangles; n must be even.
TriangleSoup saddle(int divisions = 24);

}  // namespace palpate::shapes
