#pragma once

#include "engine/math/triangle.h"

namespace palpate::stress {

// The distance of two triangles by FCL, in double and in single precision; negative where FCL is not there.
double fcl_distance(const Triangle& a, const Triangle& b);
double fcl_distance_in_single(const Triangle& a, const Triangle& b);

}  // namespace palpate::stress
