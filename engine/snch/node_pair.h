#pragma once

#include <glm/mat3x3.hpp>

#include "engine/mesh/placement.h"
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

 private:
  struct Gap;
  bool cones_miss(const Node& a, const Node& b, const Gap& gap) const;
  bool swept_boxes_miss(const Node& a, const Node& b, const Gap& gap) const;

  Placement placement_;
  glm::mat3 rotation_;
  glm::mat3 magnitude_;  // |rotation|, a little enlarged
  float ratio_;
  float cutoff_;
};

}  // namespace palpate
