#pragma once

#include "engine/math/pose.h"
#include "engine/math/vector.h"

namespace palpate {

// The rigid part of an affine matrix: its translation, and the rotation whose first axis is that of the first
// column and whose second lies in the plane of the first two. What remains, inverse(part) · matrix, is the
// scale where the matrix turns and scales, and holds mirror and shear where it has any. Axes that the matrix
// crushes to nothing are chosen.
Pose rigid_part(const DMat4& matrix);

// inverse(part) · matrix. Its translation is exactly zero where the two agree.
DMat4 relative_to(const Pose& part, const DMat4& matrix);

}  // namespace palpate
