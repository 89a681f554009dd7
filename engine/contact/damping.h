#pragma once

#include "engine/contact/spring.h"

namespace palpate {

// How far a spring is in force: 0 from the cutoff on, rising smoothly to 1 within the first eighth of the
// cutoff. What depends on which springs there are is weighed with it, so that it does not jump as one begins.
double engagement(double distance, double cutoff);

// What damping adds along the spring's direction, newtons: only while it closes, so that the sum never pulls.
// `closing_speed` in m/s, negative while the surfaces part.
double damping_force(const SpringContact& contact, double closing_speed, const SpringLaw& law);

}  // namespace palpate
