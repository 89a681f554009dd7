#pragma once

#include <glm/mat3x3.hpp>

#include "engine/mesh/placement.h"
#include "engine/snch/odometer.h"
#include "engine/snch/tree.h"

namespace palpate {

// Decides whether a pair of nodes may hold a local minimum distance within the cutoff, or surfaces that
// touch. Every test is conservative: it says no only with proof, rounding included. Lengths are in A's
// normalised frame.
//
// Based on: D. Johnson & E. Cohen, "Spatialized Normal Cone Hierarchies", I3D 2001. Ours bounds the polar
// cones rather than the face normals, tests d against the segment the cone sweeps within the cutoff rather
// than against its infinite cone, intersects both nodes' cones first, and sweeps boxes, too.
class NodePairTest {
 public:
  NodePairTest(const Placement& placement, double cutoff);

  // What a pair may still hold.
  struct Verdict {
    bool minimum;
    bool contact;
  };
  Verdict operator()(const Node& a, const Node& b) const;

  // Of two nodes that are not both leaves, which one a traversal opens: the larger.
  bool opens_first(const Node& a, const Node& b) const {
    return b.is_leaf() || (!a.is_leaf() && a.radius > ratio_ * b.radius);
  }

  // How long the pair will hold neither minimum nor contact; no certificate where it may hold one now. Facts
  // that are seen from B are certified for half their slack and at most `reach`: a point of A may turn about
  // B's centre on an arm that grows meanwhile.
  Certificate certify(const Node& a, const Node& b, const MotionRate& rate, double reach) const;

 private:
  struct Gap;
  Gap gap_between(const Node& a, const Node& b) const;
  void measure_boxes(const Node& a, const Node& b, Gap& gap) const;
  bool cones_miss(const Node& a, const Node& b, const Gap& gap) const;
  bool swept_boxes_miss(const Node& a, const Node& b, const Gap& gap) const;
  Certificate certify_directions(const Node& a, const Node& b, const Gap& gap, const MotionRate& rate,
                                 double reach) const;

  Placement placement_;
  glm::mat3 rotation_;
  glm::mat3 magnitude_;  // |rotation|, a little enlarged
  float ratio_;
  float cutoff_;
};

}  // namespace palpate
