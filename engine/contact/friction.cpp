#include "engine/contact/friction.h"

#include <algorithm>

namespace palpate {

DVec3 friction_force(double normal_force, double weight, const DVec3& slip, double coefficient) {
  const double most = coefficient * normal_force;
  if (!(most > 0.0 && weight > 0.0)) return DVec3(0.0);
  const double full_from = std::max(kSlipSpeed, most / (kFrictionDamping * weight));
  return (-most / std::max(glm::length(slip), full_from)) * slip;
}

}  // namespace palpate
