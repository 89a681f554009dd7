#include "engine/contact/spring.h"

#include <algorithm>

namespace palpate {

DVec3 spring_force(const SpringContact& contact, const SpringLaw& law) {
  const double compression = std::clamp(law.cutoff - contact.distance, 0.0, 2.0 * law.cutoff);
  return (law.stiffness * compression * contact.weight) * contact.direction;
}

Wrench wrench_about(const DVec3& reference, const DVec3& point, const DVec3& force) {
  return {force, glm::cross(point - reference, force)};
}

}  // namespace palpate
