#pragma once

#include <vector>

#include "engine/snch/feature_pair_set.h"
#include "engine/snch/lmd.h"
#include "engine/snch/near_polar.h"
#include "engine/snch/parallel_cells.h"
#include "engine/snch/room.h"

namespace palpate {

// Finds the near minima of two triangles: pairs of features that hold a local minimum distance or almost do.
// Each has a weight that is 1 well within its features and their polar cones and fades to 0 towards their
// ends and outside, so that it comes and goes continuously with the pose. A flat patch counts as one face and
// a crease line as one edge, however they are cut.
//
// Where a minimum goes over from one pair of features to another, the weights of both sum to at least 1.
class NearMinimumTest {
 public:
  using Limits = ParallelCells::Limits;

  // By two triangles: corners over the other's face, sides by sides, corners by sides, corners by corners.
  static constexpr std::size_t kMostFound = 6 + 9 + 18 + 9;

  NearMinimumTest(const NearPolar& a, const NearPolar& b, const Limits& limits,
                  std::vector<NearMinimum>& found)
      : a_(a), b_(b), limits_(limits), found_(found) {}

  void operator()(const TestedTriangle& a, const TestedTriangle& b,
                  FeaturePairSet among = FeaturePairSet::all());

  // How far beyond an end, where its patch or line goes on, a feature of the given length still holds a
  // point, so that none falls through between: by the rounding there, and by the wedge between two that turn
  // a little.
  static double seam(double length, double distance) {
    return 1e-9 * length + 2 * Creases::kStraight * distance;
  }

 private:
  struct Candidate;

  void test_corners_and_face(const NearPolar& corner_side, const TestedTriangle& corners,
                             const NearPolar& face_side, const TestedTriangle& face, FeaturePairSet among);
  void test_edges(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among);
  void test_edge_pair(const TestedTriangle& a, int i, const TestedTriangle& b, int j);
  void test_corners_and_edges(const NearPolar& corner_side, const TestedTriangle& corners,
                              const NearPolar& edge_side, const TestedTriangle& edges, FeaturePairSet among);
  void test_corner_and_edge(const NearPolar& corner_side, Feature vertex, const DVec3& corner,
                            const NearPolar& edge_side, const TestedTriangle& edges, int side);
  void test_corners(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among);
  bool within_limits(double distance) const { return distance <= limits_.cutoff && distance > limits_.touch; }
  static double way_to_end(const Candidate& candidate);
  void admit(const Candidate& candidate);

  const NearPolar a_;
  const NearPolar b_;
  const Limits limits_;
  std::vector<NearMinimum>& found_;
};

// Whether what two triangles may hold fits in where memory is fixed.
inline bool has_near_room(const std::vector<NearMinimum>& near_minima) {
  return near_minima.size() + NearMinimumTest::kMostFound <= kNearRoom;
}

// Brings near minima into an order that does not depend on how they were found, makes one of those that
// several pieces of a patch or line hold, and numbers them.
void settle_near_minima(const Creases& a, const Creases& b, std::vector<NearMinimum>& near_minima);

}  // namespace palpate
