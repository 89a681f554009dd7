#pragma once

#include "capi/src/numbers.h"
#include "capi/src/space.h"

namespace palpate::capi {

// In metres; refuses one that is not positive.
inline double cutoff_in(const Space& space, double cutoff, const char* name) {
  return checked_positive(space.length_in(checked(cutoff, name)), name);
}

}  // namespace palpate::capi
