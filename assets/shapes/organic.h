#pragma once

#include "assets/shapes/box.h"

namespace palpate::shapes {

// Cells along x, y, z of the box that is inflated into the body: 97,000 and 2,200 triangles of one and the
// same shape.
inline constexpr Divisions kOrganicFine = {104, 93, 74};
inline constexpr Divisions kOrganicCoarse = {16, 15, 10};

// A closed body with bumps, limbs and folds, 0.2 m long; star-shaped, so it never cuts itself.
TriangleSoup organic(const Divisions& divisions = kOrganicFine);

}  // namespace palpate::shapes
