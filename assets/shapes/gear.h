#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// A spur gear along z, 0.12 m across the tips: involute teeth (20 degrees), recessed web, hub with a bore.
// 12 to 40 teeth;
// 300·teeth triangles: 6,300 by default.
TriangleSoup gear(int teeth = 21);

}  // namespace palpate::shapes
