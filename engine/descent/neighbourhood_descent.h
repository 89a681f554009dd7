#pragma once

#include <vector>

#include "engine/descent/descent_pair.h"

namespace palpate {

// Local descent as the paper has it.
// Based on: [JW04 §3.1]. Around each point lies a neighbourhood: of a face itself and the triangles across
// its edges, of an edge its triangles, of a vertex all triangles around it. The closest of all pairs of the
// two neighbourhoods is the next point, until none is closer. Ours asks for a decrease beyond rounding and
// breaks ties by triangle order.
class NeighbourhoodDescent {
 public:
  // The local minimum that is reached from `start`. False: it took too many steps.
  bool descend(const DescentPair& pair, DescentPoint& point, DescentWork& work);

 private:
  std::vector<std::uint32_t> around_a_;
  std::vector<std::uint32_t> around_b_;
};

}  // namespace palpate
