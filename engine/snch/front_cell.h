#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/snch/node_batch.h"

namespace palpate {

// A pair of nodes and all pairs that a traversal opens beneath it. Nodes are in depth-first order, so those
// beneath one follow it.
struct FrontCell {
  NodePair root;
  std::uint32_t end_a;  // after the last node beneath root.a
  std::uint32_t end_b;

  static FrontCell whole(const Tree& a, const Tree& b) {
    return {{0, 0}, static_cast<std::uint32_t>(a.node_count()), static_cast<std::uint32_t>(b.node_count())};
  }

  bool holds(const NodePair& pair) const {
    return pair.a - root.a < end_a - root.a && pair.b - root.b < end_b - root.b;  // wraps below the root
  }

  // The child that holds a pair of nodes beneath the root. Which node is opened depends on the two alone.
  FrontCell child_towards(const NodePair& pair, const PackedNode& a, const PackedNode& b,
                          bool opens_first) const {
    FrontCell child = *this;
    if (opens_first) {
      narrow(child.root.a, child.end_a, pair.a, a.second_child());
    } else {
      narrow(child.root.b, child.end_b, pair.b, b.second_child());
    }
    return child;
  }

 private:
  static void narrow(std::uint32_t& root, std::uint32_t& end, std::uint32_t towards, std::uint32_t second) {
    if (towards < second) {
      ++root, end = second;
    } else {
      root = second;
    }
  }
};

// The cells above one entry of a front, the lowest of them.
class CellsAbove {
 public:
  static constexpr std::size_t kMostLevels = 16;

  // None is within what a traversal opens into features: those beneath it may have been pruned above it.
  CellsAbove(const NodeBatch& batch, const Tree& a, const Tree& b, const NodePair& entry) {
    std::size_t depth = 0;
    for (FrontCell cell = FrontCell::whole(a, b);;) {
      last_[depth++ % kMostLevels] = cell;
      if (cell.root.a == entry.a && cell.root.b == entry.b) break;
      const PackedNode &node_a = a.packed(cell.root.a), &node_b = b.packed(cell.root.b);
      if (batch.opens_features(node_a, node_b)) break;
      cell = cell.child_towards(entry, node_a, node_b, batch.opens_first(node_a, node_b));
    }
    levels_ = std::min(depth, kMostLevels);
    lowest_ = depth - 1;
  }

  // 0: the lowest, which is the entry itself where it has no feature.
  const FrontCell& operator[](std::size_t up) const { return last_[(lowest_ - up) % kMostLevels]; }
  std::size_t levels() const { return levels_; }

 private:
  std::array<FrontCell, kMostLevels> last_;  // on the way down, in turn
  std::size_t lowest_;
  std::size_t levels_;
};

}  // namespace palpate
