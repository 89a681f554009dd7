#include "engine/contact/damping.h"

#include <algorithm>

namespace palpate {

double engagement(double distance, double cutoff) {
  constexpr double kRise = 0.125;  // of the cutoff
  const double x = std::clamp((cutoff - distance) / (kRise * cutoff), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

double damping_force(const SpringContact& contact, double closing_speed, const SpringLaw& law) {
  if (!(closing_speed > 0.0)) return 0.0;
  return law.damping * closing_speed * contact.weight * engagement(contact.distance, law.cutoff);
}

}  // namespace palpate
