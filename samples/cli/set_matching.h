#pragma once

#include <cstddef>
#include <vector>

#include "palpate/palpate.h"

namespace palpate::cli {

// Pairs the sets of two outcomes, as many as can be, each with one of the other at most. Two sets may be one
// if they have a point in common: a plateau may be represented by others of its points.
class SetMatching {
 public:
  // Points count as one within `reach` metres.
  SetMatching(const plp_contacts& one, const plp_contacts& other, double reach);

  std::size_t pairs() const { return pairs_; }

 private:
  bool find_partner(std::size_t set, std::vector<bool>& asked);

  std::vector<std::vector<std::size_t>> alike_;  // by set of `one`: sets of `other`
  std::vector<std::size_t> partner_;             // by set of `other`
  std::size_t pairs_ = 0;
};

}  // namespace palpate::cli
