#pragma once

#include <array>

#include "engine/descent/descent_pair.h"
#include "engine/snch/tested_triangle.h"

namespace palpate {

// Walks over the features of two models, each time to a neighbour that is nearer, as far as they are near and
// plain: a step costs dot products for the neighbours of a feature, a tenth of what measuring two triangles
// takes. Where it ends is to be tested. It gives up where surfaces cross, are open or have two sides, and on
// plateaus; then a descent is to go its way.
//
// After B. Mirtich 1998 (V-Clip), whose steps are these. Ours does not need convex models, since it begins
// where a minimum was and nobody takes its word.
class FeatureWalk {
 public:
  explicit FeatureWalk(const DescentPair& pair);

  // Moves both to where no neighbour is nearer. False: it gave up.
  bool settle(Feature& a, Feature& b, DescentWork& work);

 private:
  enum class Step { kStands, kMoved, kLost };

  // An edge from a vertex that leads most towards a direction.
  struct Rise {
    std::uint32_t edge;
    std::uint32_t end;
    bool any;
  };
  // The face at an edge that leads towards a direction.
  struct Tilt {
    std::uint32_t face;
    bool any;
    bool outward;  // the direction leaves one of the faces
  };

  Step step();
  Step on_face(int face_side);
  Step on_edge(int edge_side);
  Step on_edges();
  Step on_corners();
  Step slide(int face_side, std::uint32_t face, std::uint32_t edge, const DVec3& from, std::uint32_t end);
  Step move(int side, FeatureKind kind, std::uint32_t index);

  bool plain(int side) const;
  DVec3 point(int side, std::uint32_t vertex) const;
  Triangle shape(int side, std::uint32_t triangle) const;
  Rise rise(int side, std::uint32_t vertex, const DVec3& u) const;
  Tilt tilt(int side, std::uint32_t edge, const DVec3& u) const;

  std::array<MeshSide, 2> sides_;
  std::array<Feature, 2> features_;
};

}  // namespace palpate
