#include "engine/contact/stiffness_cap.h"

#include "engine/contact/damping.h"
#include "engine/math/symmetric_eigenvalue.h"

namespace palpate {

void StiffnessCap::add(const SpringContact& contact, const SpringLaw& law) {
  const double stiffness = law.stiffness * contact.weight * engagement(contact.distance, law.cutoff);
  sum_ += glm::outerProduct(stiffness * contact.direction, contact.direction);
}

double StiffnessCap::scale(double most) const {
  if (!(most > 0.0)) return 1.0;
  const double stiffest = largest_eigenvalue(sum_);
  return stiffest > most ? most / stiffest : 1.0;
}

}  // namespace palpate
