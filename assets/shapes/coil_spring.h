#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// A helical spring along z, 0.1 m high, with flat wire ends. 2·across·rings triangles: 23,500 by default.
TriangleSoup coil_spring(int rings = 470, int across = 25);

}  // namespace palpate::shapes
