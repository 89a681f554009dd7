#pragma once

#include <array>
#include <vector>

#include "engine/snch/feature_pair_set.h"
#include "engine/snch/minimum.h"
#include "engine/snch/tested_triangle.h"

namespace palpate {

// Finds the cells of plateaus on two triangles: faces that are parallel, an edge along a face, edges along
// each other. All points between the cell's ends are minima though the ends may be none, such as at the foot
// of a wall. So a cell gives its corners, drawn a little inwards: they matter where no minimum of the feature
// pairs lies farther out.
class ParallelCells {
 public:
  struct Limits {
    double cutoff;              // A's normalised frame, as the next
    double touch;               // no more than this is an overlap
    double parallel_tolerance;  // radians
  };
  ParallelCells(const MeshSide& a, const MeshSide& b, const Limits& limits, std::vector<Minimum>& found)
      : a_(a), b_(b), limits_(limits), found_(found) {}

  void operator()(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among);

 private:
  // The corners of a cell, on the second model.
  struct Corners {
    std::array<DVec3, 9> point;
    std::size_t count = 0;

    void add(const DVec3& corner) { point[count++] = corner; }
  };
  // A cell that lies on `first` and `second` along `normal`, which leads from the one to the other.
  struct Cell {
    const MeshSide& first;
    Feature first_feature;
    Feature second_feature;
    DVec3 normal;
    double violation;
  };

  void test_faces(const TestedTriangle& a, const TestedTriangle& b);
  void test_edges_and_face(const MeshSide& edge_side, const TestedTriangle& edges, const MeshSide& face_side,
                           const TestedTriangle& face, FeaturePairSet among);
  void test_edge_pairs(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among);
  static Corners clipped(Corners corners, const Triangle& triangle, const DVec3& normal);
  static double width_of(const Corners& corners, const DVec3& normal);
  void emit(const Cell& cell, const Corners& corners, const DVec3& on_first);

  const MeshSide a_;
  const MeshSide b_;
  const Limits limits_;
  std::vector<Minimum>& found_;
};

}  // namespace palpate
