#pragma once

#include "engine/snch/feature_certificate.h"
#include "engine/snch/tree.h"

namespace palpate {

// Certifies for how long one feature of a triangle and the triangles of a node of the other, much finer,
// model will hold neither a minimum nor, if it is the face, touch. Where the bounds of the whole triangle
// leave all that is beneath it, a feature has few directions: a face its normal alone, a side those at right
// angles to it. So what is left of a smooth surface does not grow as it is cut finer.
class CoarseCertificate {
 public:
  CoarseCertificate(const MeshSide& coarse_side, const MeshSide& fine_side,
                    const FeatureCertificate& features, const FeaturePairTest::Limits& limits)
      : coarse_(coarse_side), fine_(fine_side), features_(features), limits_(limits) {}

  Certificate operator()(const TestedTriangle& triangle, TrianglePlace place, const Node& node) const;

 private:
  // A node in A's frame.
  struct Bound;

  Bound bound_of(const Node& node) const;
  Certificate face(const TestedTriangle& triangle, const Bound& fine) const;
  Certificate side(const TestedTriangle& triangle, int k, const Bound& fine) const;
  Certificate corner(const TestedTriangle& triangle, int k, const Bound& fine) const;
  Certificate along_cone(const DVec3& from, const DVec3& to, const Bound& fine) const;
  Certificate leaning(const Feature& feature, const Bound& fine, bool near) const;

  const MeshSide coarse_;
  const MeshSide fine_;
  const FeatureCertificate& features_;
  const FeaturePairTest::Limits limits_;
};

}  // namespace palpate
