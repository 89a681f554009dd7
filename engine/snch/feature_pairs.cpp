#include "engine/snch/feature_pairs.h"

#include <algorithm>
#include <cmath>

#include "engine/kernel/line_pair.h"
#include "engine/mesh/polar_cone.h"

namespace palpate {
namespace {

// Points must lie this far from the end of a feature, relative to its size, to be on it. Nearer they are on
// the lower feature at its end, whose own polar cone decides, with a tolerance that covers this.
constexpr double kEnd = 1e-12;

// Edges that differ less than this (radians) have a common normal that is rounding for the most part: the
// direction is that between their closest points.
constexpr double kNearlyParallel = 1e-9;

// Edges that differ less than this are parallel: their minima are those of their ends, at any distance that
// is no touch.
constexpr double kParallel = 2e-15;

// Rounding of a point's coordinates, as a part of the distance that counts as touching.
constexpr double kRoundingOfTouch = 0.2;

}  // namespace

// `point_first` is on the model that `first` names, `normal` points from there to the other.
struct FeaturePairTest::Candidate {
  const MeshSide& first;
  const MeshSide& second;
  Feature first_feature;
  Feature second_feature;
  DVec3 first_point;
  DVec3 second_point;
  DVec3 normal;
  double distance;
  double margin;     // distance of the points from the ends of their features
  double tolerance;  // of a direction outside its polar cone
  bool test_first;   // against its polar cone: a face's own normal needs none
};

FeaturePairTest::FeaturePairTest(const Mesh& a, const Mesh& b, const Placement& placement,
                                 const Limits& limits, std::vector<Minimum>& found)
    : placement_(placement),
      limits_(limits),
      a_{a, placement_, false},
      b_{b, placement_, true},
      cells_(a_, b_, limits, found),
      found_(found) {}

void FeaturePairTest::operator()(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among) {
  test_corners_and_face(b_, b, a_, a, among);
  test_corners_and_face(a_, a, b_, b, among);
  test_edges(a, b, among);
  test_corners_and_edges(b_, b, a_, a, among);
  test_corners_and_edges(a_, a, b_, b, among);
  test_corners(a, b, among);
  cells_(a, b, among);
}

void FeaturePairTest::test_corners_and_face(const MeshSide& corner_side, const TestedTriangle& corners,
                                            const MeshSide& face_side, const TestedTriangle& face,
                                            FeaturePairSet among) {
  if (!corners.corners || !among.has_any(FeaturePairSet::corner_and_face(corner_side.is_b, 0), 3)) return;
  const Triangle& triangle = face.shape;
  const DVec3 face_normal = face_side.normal(face);
  for (int k = 0; k < 3; ++k) {
    if (!corners.has_corner(k) || !among.has(FeaturePairSet::corner_and_face(corner_side.is_b, k))) continue;
    const DVec3& corner = corners.shape.corner[k];
    const double height = glm::dot(corner - triangle.corner[0], face_normal);
    const double distance = std::abs(height);
    if (distance > limits_.cutoff || distance <= limits_.touch) continue;
    if (height < 0 && !face_side.mesh.double_sided[face.index]) continue;
    double margin = limits_.cutoff;
    for (int side = 0; side < 3; ++side) {
      const DVec3 along = triangle.along(side);
      const double length = glm::length(along);
      const double inside = glm::dot(glm::cross(face_normal, along), corner - triangle.start(side)) / length;
      margin = std::min(margin, inside - kEnd * length);
    }
    if (margin <= limits_.touch) continue;
    admit({face_side, corner_side, face_side.face(face), corner_side.vertex(corners, k),
           corner - face_normal * height, corner, height < 0 ? -face_normal : face_normal, distance, margin,
           limits_.parallel_tolerance, false});
  }
}

void FeaturePairTest::test_edges(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among) {
  for (int i = 0; i < 3; ++i) {
    if (!a.has_side(i)) continue;
    for (int j = 0; j < 3; ++j) {
      if (!b.has_side(j) || !among.has(FeaturePairSet::edges(i, j))) continue;
      const DVec3 u = a.shape.along(i), v = b.shape.along(j);
      const DVec3 &start_a = a.shape.start(i), &start_b = b.shape.start(j);
      const LinePair lines(start_a, u, start_b, v);
      if (!lines.inclined(u, v, kParallel)) continue;
      const double end = std::min(std::min(lines.s, 1 - lines.s) * glm::length(u),
                                  std::min(lines.t, 1 - lines.t) * glm::length(v));
      if (!(end > kEnd * (glm::length(u) + glm::length(v)) + limits_.touch)) continue;
      if (!lines.inclined(u, v, kNearlyParallel)) {
        test_nearly_parallel_edges(a, i, b, j, lines.s, end);
        continue;
      }
      const DVec3 unit = lines.normal / std::sqrt(lines.normal_squared);
      const double height = glm::dot(start_b - start_a, unit);
      const double distance = std::abs(height);
      if (distance > limits_.cutoff || distance <= limits_.touch) continue;
      admit({a_, b_, a_.edge(a, i), b_.edge(b, j), start_a + lines.s * u, start_b + lines.t * v,
             height < 0 ? -unit : unit, distance, end, limits_.parallel_tolerance, true});
    }
  }
}

// The closer the edges, the more a slight crossing matters: their ends lean by the angle times their length
// over the distance. Where along the edge they cross is known less well than the point that is closest to it.
void FeaturePairTest::test_nearly_parallel_edges(const TestedTriangle& a, int i, const TestedTriangle& b,
                                                 int j, double place_a, double end) {
  const DVec3 v = b.shape.along(j);
  const DVec3 on_a = a.shape.start(i) + place_a * a.shape.along(i);
  const DVec3 on_b = b.shape.start(j) + v * (glm::dot(on_a - b.shape.start(j), v) / glm::dot(v, v));
  const DVec3 between = on_b - on_a;
  const double distance = glm::length(between);
  if (distance > limits_.cutoff || distance <= limits_.touch) return;
  admit({a_, b_, a_.edge(a, i), b_.edge(b, j), on_a, on_b, between / distance, distance, end,
         limits_.parallel_tolerance + kRoundingOfTouch * limits_.touch / distance, true});
}

void FeaturePairTest::test_corners_and_edges(const MeshSide& corner_side, const TestedTriangle& corners,
                                             const MeshSide& edge_side, const TestedTriangle& edges,
                                             FeaturePairSet among) {
  if (!corners.corners || !among.has_any(FeaturePairSet::corner_and_edge(corner_side.is_b, 0, 0), 9)) return;
  for (int j = 0; j < 3; ++j) {
    if (!edges.has_side(j)) continue;
    const DVec3 along = edges.shape.along(j);
    const double length = glm::length(along);
    for (int k = 0; k < 3; ++k) {
      if (!corners.has_corner(k) || !among.has(FeaturePairSet::corner_and_edge(corner_side.is_b, k, j)))
        continue;
      const DVec3& corner = corners.shape.corner[k];
      const double place = glm::dot(corner - edges.shape.start(j), along) / length;
      const double end = std::min(place, length - place);
      if (!(end > kEnd * length + limits_.touch)) continue;
      const DVec3 foot = edges.shape.start(j) + along * (place / length);
      const DVec3 between = corner - foot;
      const double distance = glm::length(between);
      if (distance > limits_.cutoff || distance <= limits_.touch) continue;
      admit({edge_side, corner_side, edge_side.edge(edges, j), corner_side.vertex(corners, k), foot, corner,
             between / distance, distance, end,
             limits_.parallel_tolerance + kRoundingOfTouch * limits_.touch / distance, true});
    }
  }
}

void FeaturePairTest::test_corners(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among) {
  for (int i = 0; i < 3; ++i) {
    if (!a.has_corner(i)) continue;
    for (int j = 0; j < 3; ++j) {
      if (!b.has_corner(j) || !among.has(FeaturePairSet::corners(i, j))) continue;
      const DVec3 between = b.shape.corner[j] - a.shape.corner[i];
      const double distance = glm::length(between);
      if (distance > limits_.cutoff || distance <= limits_.touch) continue;
      admit({a_, b_, a_.vertex(a, i), b_.vertex(b, j), a.shape.corner[i], b.shape.corner[j],
             between / distance, distance, limits_.cutoff,
             limits_.parallel_tolerance + kRoundingOfTouch * limits_.touch / distance, true});
    }
  }
}

// Section by section the definition of a local minimum distance: minimal on both sides, outward on both
// sides.
void FeaturePairTest::admit(const Candidate& c) {
  const double second = c.second.violation(c.second_feature, -c.normal);
  if (second > c.tolerance) return;
  const double first = c.test_first ? c.first.violation(c.first_feature, c.normal) : second;
  if (first > c.tolerance) return;
  if (!c.first.outward(c.first_feature, c.normal) || !c.second.outward(c.second_feature, -c.normal)) return;

  const double most = std::max(first, second);
  const bool alone = most < -c.tolerance && c.margin > 4 * c.tolerance * c.distance;
  const bool swapped = c.first.is_b;
  found_.push_back({swapped ? c.second_feature : c.first_feature,
                    swapped ? c.first_feature : c.second_feature, swapped ? c.second_point : c.first_point,
                    swapped ? c.first_point : c.second_point, swapped ? -c.normal : c.normal, c.distance,
                    most, alone, false});
}

}  // namespace palpate
