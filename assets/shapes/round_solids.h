#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// Axis z, around the origin; `rings` cross-sections from end to end. 2·segments·rings triangles.
TriangleSoup cylinder(double radius, double height, int segments = 48, int rings = 9);

// Axis z. 2·around·across triangles.
TriangleSoup torus(double ring_radius, double tube_radius, int around = 64, int across = 32);

// A cone so flat that it is nearly a disc; its apex and the middle of its base are vertices of valence n. 2n
// triangles.
TriangleSoup fan(int valence = 200);

}  // namespace palpate::shapes
