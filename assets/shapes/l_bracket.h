#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// Two arms of 0.125 m at a right angle: 20 triangles, one reflex edge.
TriangleSoup l_bracket();

}  // namespace palpate::shapes
