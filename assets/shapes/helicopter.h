#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// A helicopter 0.3 m long, nose towards +x, rotor axis z: closed parts that overlap, as in a modelled
// assembly. 113,000 triangles in 18 parts.
TriangleSoup helicopter();

}  // namespace palpate::shapes
