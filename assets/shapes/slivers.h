#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// A square bar whose walls are saw teeth of every height from 2^-23 m to 2^-4 m: long triangles of an aspect
// (longest side over shortest height) up to a million, on convex and on reflex edges. All positions are exact
// in float32.
TriangleSoup slivers();

}  // namespace palpate::shapes
