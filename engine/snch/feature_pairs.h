#pragma once

#include <vector>

#include "engine/snch/minimum.h"
#include "engine/snch/model.h"
#include "engine/snch/placement.h"
#include "engine/snch/tree.h"

namespace palpate {

// Tests the feature pairs that two triangles own between them for local minimum distances: corner and face,
// edge and edge, corner and edge, corner and corner. Every pair of features is owned by exactly one pair of
// triangles. The decision is taken in double precision by this one path.
class FeaturePairTest {
 public:
  struct Limits {
    double cutoff;              // A's normalised frame, as the next
    double touch;               // no more than this is an overlap
    double parallel_tolerance;  // radians
  };
  FeaturePairTest(const Model& a, const Model& b, const Placement& placement, const Limits& limits,
                  std::vector<Minimum>& found);

  // Triangles by index and by corners, both in A's frame.
  void operator()(std::uint32_t a, const Triangle& in_a, std::uint32_t b, const Triangle& in_b);

 private:
  // One of the two models, its directions turned out of A's frame if it is B.
  struct Side {
    const Mesh& mesh;
    const Tree& tree;
    bool second;
  };
  // A pair of features under test.
  struct Candidate;

  void test_corners_and_face(const Side& corner_side, std::uint32_t corners_of, const Triangle& corners,
                             const Side& face_side, std::uint32_t face, const Triangle& triangle);
  void test_edges(std::uint32_t a, const Triangle& in_a, std::uint32_t b, const Triangle& in_b);
  void test_corners_and_edges(const Side& corner_side, std::uint32_t corners_of, const Triangle& corners,
                              const Side& edge_side, std::uint32_t edges_of, const Triangle& edges);
  void test_corners(std::uint32_t a, const Triangle& in_a, std::uint32_t b, const Triangle& in_b);

  bool admit(Candidate& candidate) const;
  double violation(const Side& side, Feature feature, const DVec3& u) const;
  bool outward(const Side& side, Feature feature, const DVec3& u) const;

  Placement placement_;
  Limits limits_;
  Side a_;
  Side b_;
  std::vector<Minimum>& found_;
};

}  // namespace palpate
