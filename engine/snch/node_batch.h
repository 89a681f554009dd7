#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/mesh/placement.h"
#include "engine/snch/feature_node.h"
#include "engine/snch/odometer.h"
#include "engine/snch/tree.h"

namespace palpate {

// Two nodes, one of each tree, by index; of one of them it may be a feature, by the code of a FeatureNode.
struct NodePair {
  std::uint32_t a;
  std::uint32_t b;
};

// Decides for many pairs of nodes at once whether each may hold a local minimum distance within the cutoff,
// or surfaces that touch. Every test is conservative: it says no only with proof, rounding included. Lengths
// are in A's normalised frame. Wide: as many pairs together as the processor has lanes; every instruction set
// gives the same bits.
//
// Based on: D. Johnson & E. Cohen, "Spatialized Normal Cone Hierarchies", I3D 2001. Ours bounds the polar
// cones rather than the face normals, tests d against the segment the cone sweeps within the cutoff rather
// than against its infinite cone, intersects both nodes' cones first, and sweeps boxes, too.
class NodeBatch {
 public:
  static constexpr std::size_t kMost = 16;  // pairs a call

  // What a pair may still hold.
  struct Verdict {
    bool minimum;
    bool contact;
  };
  using Verdicts = std::array<Verdict, kMost>;

  // How long a pair will hold neither minimum nor contact; 0 in one of both where it may hold one now.
  struct Certificates {
    alignas(64) std::array<float, kMost> distance;
    alignas(64) std::array<float, kMost> angle;

    Certificate of(std::size_t i) const { return {distance[i], angle[i]}; }
  };

  NodeBatch(const Tree& a, const Tree& b, const Placement& placement, double cutoff);

  // One to kMost pairs.
  void judge(std::span<const NodePair> pairs, Verdicts& verdicts);

  // `reach` is the odometer's.
  void certify(std::span<const NodePair> pairs, const MotionRate& rate, double reach,
               Certificates& certificates);

  // One of two nodes is a leaf so much coarser than the other, which is none, that a traversal opens it into
  // its features, and then the other alone.
  bool opens_features(const PackedNode& a, const PackedNode& b) const {
    if (a.is_leaf() == b.is_leaf() || !tells_features_) return false;
    const float radius_a = a.sphere_radius(), radius_b = view_.ratio * b.sphere_radius();
    return a.is_leaf() ? radius_a > kCoarse * radius_b : radius_b > kCoarse * radius_a;
  }

  // Of two nodes that are not both leaves, which one a traversal opens: the larger.
  bool opens_first(const PackedNode& a, const PackedNode& b) const {
    return b.is_leaf() || (!a.is_leaf() && a.sphere_radius() > view_.ratio * b.sphere_radius());
  }

  // What every pair has in common.
  struct View {
    double linear[3][3];  // of the placement, by column
    double translation[3];
    float rotation[3][3];   // by column
    float magnitude[3][3];  // |rotation|, a little enlarged
    float ratio;
    float cutoff;
  };

  // Nodes in halves of four words, so laid out that a wide load gets the same half of every fourth.
  struct Rows {
    alignas(64) std::array<std::array<std::uint32_t, kMost>, 4> halves[2];

    void set(std::size_t i, const PackedNode& node) {
      const auto words = std::bit_cast<std::array<std::array<std::uint32_t, 4>, 2>>(node);
      for (std::size_t half = 0; half < 2; ++half)
        std::copy_n(words[half].data(), 4, halves[half][i % 4].data() + i / 4 * 4);
    }
  };

 private:
  static constexpr float kCoarse = 3.0f;

  void gather(std::span<const NodePair> pairs);

  const Tree& a_;
  const Tree& b_;
  View view_;
  Rows rows_a_;
  Rows rows_b_;
  bool tells_features_;
};

}  // namespace palpate
