#pragma once

#include <vector>

#include "engine/mesh/placement.h"
#include "engine/snch/minimum.h"

namespace palpate {

// A triangle under test, its corners in A's frame, and which of its corners and sides take part (bit k:
// corner or side k). Its face always does.
struct TestedTriangle {
  std::uint32_t index;
  Triangle shape;
  unsigned corners;
  unsigned sides;
};

// Tests the feature pairs of two triangles for local minimum distances: corner and face, edge and edge,
// corner and edge, corner and corner. Every decision on an LMD is taken by this one path, in double
// precision.
class FeaturePairTest {
 public:
  struct Limits {
    double cutoff;              // A's normalised frame, as the next
    double touch;               // no more than this is an overlap
    double parallel_tolerance;  // radians
  };
  FeaturePairTest(const Mesh& a, const Mesh& b, const Placement& placement, const Limits& limits,
                  std::vector<Minimum>& found);

  void operator()(const TestedTriangle& a, const TestedTriangle& b);

 private:
  // One of the two models, its directions turned out of A's frame if it is B.
  struct Side {
    const Mesh& mesh;
    bool second;
  };
  // A pair of features under test.
  struct Candidate;

  void test_corners_and_face(const Side& corner_side, const TestedTriangle& corners, const Side& face_side,
                             const TestedTriangle& face);
  void test_edges(const TestedTriangle& a, const TestedTriangle& b);
  void test_corners_and_edges(const Side& corner_side, const TestedTriangle& corners, const Side& edge_side,
                              const TestedTriangle& edges);
  void test_corners(const TestedTriangle& a, const TestedTriangle& b);

  bool admit(const Candidate& candidate) const;
  double violation(const Side& side, Feature feature, const DVec3& u) const;
  bool outward(const Side& side, Feature feature, const DVec3& u) const;

  Placement placement_;
  Limits limits_;
  Side a_;
  Side b_;
  std::vector<Minimum>& found_;
};

}  // namespace palpate
