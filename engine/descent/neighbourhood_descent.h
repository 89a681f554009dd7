#pragma once

#include <array>
#include <vector>

#include "engine/descent/descent_pair.h"
#include "engine/kernel/triangle_batch.h"

namespace palpate {

// Local descent as the paper has it.
// Based on: [JW04 §3.1]. Around each point lies a neighbourhood: of a face itself and the triangles across
// its edges, of an edge its triangles, of a vertex all triangles around it. The closest of all pairs of the
// two neighbourhoods is the next point, until none is closer. Ours asks for a decrease beyond rounding and
// breaks ties by triangle order; it leaves out pairs whose closest points are those that it has, and lets
// single precision tell which of the others cannot be closer.
class NeighbourhoodDescent {
 public:
  // The local minimum that is reached from `start`. False: it took too many steps.
  bool descend(const DescentPair& pair, DescentPoint& point, DescentWork& work);

 private:
  // A triangle of a neighbourhood, in A's frame. It `may_lead_nearer` unless it holds the present point and
  // no direction from there towards the other model.
  struct Neighbour {
    std::uint32_t index;
    Triangle shape;
    bool may_lead_nearer;
  };
  using Neighbours = std::vector<Neighbour>;

  void surround(const DescentPair& pair, const DescentPoint& point);
  void move_to_closest(const DescentPair& pair, DescentPoint& point, DescentWork& work);
  void decide(const DescentPair& pair, std::size_t count, DescentPoint& closest, DescentWork& work);

  std::vector<std::uint32_t> around_;
  Neighbours around_a_;
  Neighbours around_b_;
  std::array<TrianglePair, TriangleBatch::kMost> pairs_;
  TriangleBatch batch_{};  // of these
  TriangleBatch::Closest measured_;
};

}  // namespace palpate
