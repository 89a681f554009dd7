#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// A gently waved square, 0.2 m, with a boundary: 2·divisions² triangles, facing +z.
TriangleSoup open_sheet(int divisions = 32);

// The same, every triangle double-sided.
TriangleSoup two_sided_sheet(int divisions = 32);

// A closed band with half a twist: it has one side and cannot be wound consistently; double-sided.
TriangleSoup mobius_strip(int around = 120, int across = 8);

}  // namespace palpate::shapes
