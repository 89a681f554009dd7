#pragma once

#include <vector>

#include "engine/snch/feature_pair_set.h"
#include "engine/snch/minimum.h"
#include "engine/snch/parallel_cells.h"
#include "engine/snch/tested_triangle.h"

namespace palpate {

// Tests the feature pairs of two triangles for local minimum distances: corner and face, edge and edge,
// corner and edge, corner and corner. Every decision on an LMD is taken by this one path, in double
// precision.
class FeaturePairTest {
 public:
  using Limits = ParallelCells::Limits;

  // One call finds fewer: 42 pairs of features and the corners of 16 cells.
  static constexpr std::size_t kMostFound = 256;

  FeaturePairTest(const Mesh& a, const Mesh& b, const Placement& placement, const Limits& limits,
                  std::vector<Minimum>& found);

  void operator()(const TestedTriangle& a, const TestedTriangle& b,
                  FeaturePairSet among = FeaturePairSet::all());

 private:
  // A pair of features under test.
  struct Candidate;

  void test_corners_and_face(const MeshSide& corner_side, const TestedTriangle& corners,
                             const MeshSide& face_side, const TestedTriangle& face, FeaturePairSet among);
  void test_edges(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among);
  void test_nearly_parallel_edges(const TestedTriangle& a, int i, const TestedTriangle& b, int j,
                                  double place_a, double end);
  void test_corners_and_edges(const MeshSide& corner_side, const TestedTriangle& corners,
                              const MeshSide& edge_side, const TestedTriangle& edges, FeaturePairSet among);
  void test_corners(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among);

  void admit(const Candidate& candidate);

  Placement placement_;
  Limits limits_;
  MeshSide a_;
  MeshSide b_;
  ParallelCells cells_;
  std::vector<Minimum>& found_;
};

}  // namespace palpate
