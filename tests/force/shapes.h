#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// A ridge: a prism around the origin along x whose sharp edge, at z = 0, points up.
TriangleSoup ridge(double length, double width, double height, int divisions = 1);

// A solid whose upper side is a dent of the given radius of curvature, finely cut: a bowl, slightly reflex at
// every edge. Its lowest point is the origin.
TriangleSoup bowl(double radius, double half_width, int divisions);

// A pyramid with its tip at the origin, pointing down.
TriangleSoup stylus(double height, double half_width);

// Every triangle cut into four at the middles of its sides, in its own plane.
TriangleSoup refined(const TriangleSoup& soup);

}  // namespace palpate::shapes
