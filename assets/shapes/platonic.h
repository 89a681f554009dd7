#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// Regular, corners on a sphere of the given radius around the origin.
TriangleSoup tetrahedron(double radius = 0.1);

// An icosahedron with every edge cut into `frequency` parts, all vertices on the sphere: 20·frequency²
// triangles.
TriangleSoup icosphere(double radius = 0.1, int frequency = 8);

// Spheres in spheres: a hollow ball that holds another hollow ball. Cavity walls face the cavity.
TriangleSoup nested_cavities(int frequency = 12);

}  // namespace palpate::shapes
