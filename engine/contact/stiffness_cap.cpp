#include "engine/contact/stiffness_cap.h"

#include <algorithm>

#include "engine/math/cholesky.h"

namespace palpate {

// The energy over κ of springs whose tool has yielded, metres squared: convex, once differentiable and
// quadratic in pieces.
class StiffnessCap::Yielding {
 public:
  Yielding(std::span<const Spring> springs, double most, const DVec4& yielded)
      : yielded_(yielded), energy_(0.5 * glm::dot(yielded, yielded)), slope_(yielded) {
    for (const Spring& spring : springs) add(spring, spring.stiffness / most);
  }

  const DVec4& yielded() const { return yielded_; }

  // From here to where the pieces of here would be at rest.
  DVec4 newton_step() const { return solve_symmetric(curvature_, -slope_); }

  // Whether nothing is left to yield but rounding.
  bool at_rest() const {
    constexpr double kRounding = 1e-15;
    const DVec4 left = glm::abs(slope_);
    return std::max({left.x, left.y, left.z, left.w}) <= kRounding * cancelled_;
  }

  // Armijo's rule. Where the energy is level but for rounding, Newton's steps are taken as they come.
  bool descends_to(const Yielding& other, const DVec4& step) const {
    constexpr double kPart = 1e-4, kLevel = 1e-10;
    const double expected = -glm::dot(slope_, step);
    return expected <= kLevel * energy_ || other.energy_ <= energy_ - kPart * expected;
  }

 private:
  void add(const Spring& spring, double stiffness) {
    const double pressed = spring.compression - glm::dot(spring.direction, yielded_);
    if (!(pressed > 0.0)) return;
    const double counted = std::min(pressed, spring.most);
    energy_ += stiffness * counted * (pressed - 0.5 * counted);
    slope_ -= (stiffness * counted) * spring.direction;
    cancelled_ += stiffness * spring.compression;
    if (pressed >= spring.most) return;
    const DVec4 side = stiffness * spring.direction;
    for (int column = 0; column < 4; ++column)
      for (int row = column; row < 4; ++row) curvature_[column][row] += side[row] * spring.direction[column];
  }

  DVec4 yielded_;  // metres: translation, retreat
  double energy_;
  DVec4 slope_;
  DMat4 curvature_{1.0};    // its lower half
  double cancelled_ = 0.0;  // metres: what the slope is the small rest of
};

void StiffnessCap::reserve(std::size_t springs) {
  springs_.reserve(springs);
  shares_.reserve(springs);
}

void StiffnessCap::add(const SpringContact& contact, const SpringLaw& law) {
  springs_.push_back({DVec4(contact.direction, 1.0), law.stiffness * contact.weight,
                      law.cutoff - contact.distance, 2.0 * law.cutoff});
}

std::span<const double> StiffnessCap::shares(double most) {
  shares_.assign(springs_.size(), 1.0);
  steps_ = 0;
  if (!(most > 0.0)) return shares_;
  const double solved = std::max(most, least_solved());
  const DVec4 yielded = yielded_under(solved);
  for (std::size_t i = 0; i < springs_.size(); ++i)
    shares_[i] = most / solved * share_of(springs_[i], yielded);
  return shares_;
}

// Of a cap much lower than this the matrices hold nothing but rounding. There the tool yields all the way,
// and the force is in proportion to the cap.
double StiffnessCap::least_solved() const {
  constexpr double kPart = 1e-7;
  double stiffness = 0.0;
  for (const Spring& spring : springs_) stiffness += spring.stiffness;
  return kPart * stiffness;
}

// Newton's method, which begins where all springs push and lets go of some until the rest are right. Its end
// is exact, because the pieces are quadratic.
DVec4 StiffnessCap::yielded_under(double most) {
  constexpr int kMostSteps = 64, kMostHalvings = 32;
  Yielding here(springs_, most, DVec4(0.0));
  for (; steps_ < kMostSteps && !here.at_rest(); ++steps_) {
    DVec4 step = here.newton_step();
    Yielding there(springs_, most, here.yielded() + step);
    for (int i = 0; i < kMostHalvings && !here.descends_to(there, step); ++i) {
      step *= 0.5;
      there = Yielding(springs_, most, here.yielded() + step);
    }
    here = there;
  }
  return here.yielded();
}

double StiffnessCap::share_of(const Spring& spring, const DVec4& yielded) {
  const double alone = std::min(spring.compression, spring.most);
  if (!(alone > 0.0)) return 0.0;
  const double pressed = spring.compression - glm::dot(spring.direction, yielded);
  return std::clamp(std::min(pressed, spring.most) / alone, 0.0, 1.0);
}

}  // namespace palpate
