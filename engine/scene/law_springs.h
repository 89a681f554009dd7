#pragma once

#include <span>
#include <vector>

#include "engine/contact/smooth_law.h"
#include "engine/snch/lmd.h"

namespace palpate {

enum class ForceLaw {
  kSprings,  // each LMD pushes: the paper's
  kSmooth,   // near minima share: continuous in the pose
};

// What pushes of what a search found, by a force law. Keeps its memory.
class LawSprings {
 public:
  void reserve(std::size_t springs);

  // LMDs whose weights are what a spring of each pushes with, metres. Under the smooth law each is a set of
  // its own. Valid until the next call, and as long as `found`.
  std::span<const Lmd> of(const LmdSet& found, ForceLaw law, double cutoff);

 private:
  SmoothLaw smooth_;
  std::vector<NearContact> near_;
  std::vector<Lmd> springs_;
};

}  // namespace palpate
