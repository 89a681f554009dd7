#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// From the units of Newell's control points, in which the pot is 6.434 long, to 0.3 m around the origin.
inline constexpr double kTeapotMetresPerUnit = 0.3 / 6.434;
inline constexpr DVec3 kTeapotCentre{0.217, 0.0, 1.65};

// Newell's teapot of 28 Bézier patches (no bottom), z up, each patch cut into n × n cells of two triangles:
// 56·n², 5,600 by default. An open surface: body, handle and spout only intersect. The triangles at the pole
// of the lid that have no area are kept, as in the classic file.
TriangleSoup teapot(int divisions = 10);

}  // namespace palpate::shapes
