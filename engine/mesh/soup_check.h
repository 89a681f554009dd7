#pragma once

#include "engine/math/box.h"
#include "engine/mesh/clean_triangles.h"

namespace palpate {

// Checks options, index range and finiteness; returns the bounds (metres) of the vertices that triangles use.
// Other vertices are ignored, whatever they hold.
Result<Box> check_soup(const TriangleSoup& soup, const MeshOptions& options);

}  // namespace palpate
