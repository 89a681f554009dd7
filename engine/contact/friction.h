#pragma once

#include "engine/math/vector.h"

namespace palpate {

// Friction is never more than this many N·s/m for a spring of weight 1: below a slip of
// μ F / kFrictionDamping, or of kSlipSpeed, it is viscous rather than Coulomb's, because the full force that
// turns about with the sign of a sampled velocity would shake a hand at rest.
inline constexpr double kFrictionDamping = 20.0;
inline constexpr double kSlipSpeed = 0.005;  // m/s

// The force on the tool of a spring that presses with `normal_force` newtons while the tool slips along the
// surface at `slip` m/s: −μ F v / max(|v|, v_s), Coulomb's regularised. It only takes energy.
DVec3 friction_force(double normal_force, double weight, const DVec3& slip, double coefficient);

}  // namespace palpate
