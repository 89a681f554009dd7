#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/contact/spring.h"

namespace palpate {

// Many springs at once may be stiffer than a device can be without shaking. Under a cap κ all yield together,
// as if they pushed a virtual tool that hangs on the true one by springs of κ and gives way to them: spring
// i, of stiffness a = k w, compressed by x, pushes with
//
//   f_i = a_i max(0, x_i − (u_i·F + P) / κ),  F = Σ f_j u_j the force,  P = Σ f_j the pressure.
//
// Based on: J.-J. Moreau, Proximité et dualité dans un espace hilbertien, 1965. F is the slope of the
// envelope of the springs' energy over (translation, retreat), so that for springs that keep place and
// direction, any number in any directions,
// - the stiffness against translation is κ or less in every direction and nowhere negative: the force never
//   falls while the hand presses in, and closed paths of translation give no energy;
// - no spring pushes more than it would alone, nor is one stiffer against rotation;
// - no force jumps where a spring begins, whether by its distance or by its weight: for u_i·u_j + 1 ≥ 0, no
//   spring is pressed by what others yield. That is what the retreat is for.
// A face alone is at most κ/2 stiff, k / (1 + 2 k / κ), because there may be another across: from a tool
// between two faces the hand feels both. No law can do better that is continuous and knows only springs
// within the cutoff: where the second one begins the first pushes already, and as far on they have changed
// places.
class StiffnessCap {
 public:
  void reserve(std::size_t springs);
  void clear() { springs_.clear(); }
  void add(const SpringContact& contact, const SpringLaw& law);

  // What each spring keeps of its force, from 0 to 1, in the order in which they were added. `most` in N/m: 0
  // or less is no cap. Valid until the next call. Allocates nothing for as many springs as before.
  std::span<const double> shares(double most);

  // Steps of Newton's method that the last shares() took.
  int steps() const { return steps_; }

 private:
  struct Spring {
    DVec4 direction;     // the unit vector, and 1 for the retreat
    double stiffness;    // N/m
    double compression;  // metres, may be negative
    double most;         // metres of compression beyond which it does not grow: that of a wall
  };
  class Yielding;

  double least_solved() const;
  DVec4 yielded_under(double most);
  static double share_of(const Spring& spring, const DVec4& yielded);

  std::vector<Spring> springs_;
  std::vector<double> shares_;
  int steps_ = 0;
};

}  // namespace palpate
