#include "engine/scene/law_springs.h"

namespace palpate {

void LawSprings::reserve(std::size_t springs) {
  smooth_.reserve(springs);
  near_.reserve(springs);
  springs_.reserve(springs);
}

std::span<const Lmd> LawSprings::of(const LmdSet& found, ForceLaw law, double cutoff) {
  if (law == ForceLaw::kSprings) return found.lmds;
  near_.clear();
  for (const Lmd& near : found.near_minima)
    near_.push_back({near.point_a, near.point_b, near.normal, near.distance, near.weight});
  const std::span<const double> factors = smooth_.share(near_, cutoff);
  springs_.assign(found.near_minima.begin(), found.near_minima.end());
  for (std::size_t i = 0; i < springs_.size(); ++i) springs_[i].weight = factors[i];
  return springs_;
}

}  // namespace palpate
