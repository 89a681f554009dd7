#pragma once

#include "tests/stress/families.h"

namespace palpate::stress {

// What scenes made of forces.
struct ForceOutcome {
  int held = 0;               // cases in which the tool was held still
  int unsteady = 0;           // of these, in which the wrench was not the same bits from step to step
  int not_numbers = 0;        // steps
  int wild = 0;               // steps with more force than all springs that push can make
  int motions = 0;            // past the pose without an overlap
  double largest_jump = 0.0;  // of the smooth law along these, in k·c or k·c times the tool's radius

  void add(const ForceOutcome& other);
  int faults() const { return unsteady + not_numbers + wild; }
};

// Moves a tool to a case's pose in steps of 1e-5 to 1 s, and holds it there; then looks for jumps of the
// smooth law's force around it.
ForceOutcome stress_force(const Case& c, Random& random);

}  // namespace palpate::stress
