#pragma once

#include "engine/contact/spring.h"

namespace palpate {

// Many springs at once may be stiffer than a device can be without shaking. This sums the tool's stiffness
// against translation, Σ k w u uᵀ, and tells by how much all have to yield.
class StiffnessCap {
 public:
  void clear() { sum_ = DMat3(0.0); }

  // A spring counts as far as it is engaged, so that the scale does not jump where one begins.
  void add(const SpringContact& contact, const SpringLaw& law);

  // Of all forces: 1, or what makes the stiffest direction as stiff as `most` (N/m; 0: no cap).
  double scale(double most) const;

 private:
  DMat3 sum_{0.0};
};

}  // namespace palpate
