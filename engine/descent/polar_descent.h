#pragma once

#include "engine/descent/descent_pair.h"

namespace palpate {

// Local descent by polar cones: the direction between the points is tested against the polar cone of the
// feature that each lies on, a dot product for every edge there. Where it leans outside, the next point is on
// the face that holds the direction of the largest lean. The worse side moves first, then the other, then
// both, then any face around: so shallow barriers do not stop it, and it does not jump over them either.
//
// After [JW04 §3.1], which measures all pairs of two neighbourhoods instead.
class PolarDescent {
 public:
  // Moves `point` to a local minimum. False: it took too many steps.
  bool descend(const DescentPair& pair, DescentPoint& point, DescentWork& work) const;

 private:
  bool step(const DescentPair& pair, DescentPoint& point, DescentWork& work) const;
};

}  // namespace palpate
