#include "engine/snch/feature_certificate.h"

#include <algorithm>
#include <cmath>

#include "engine/kernel/line_pair.h"
#include "engine/kernel/triangle_pair.h"

namespace palpate {
namespace {

// A certificate that holds for so many ticks need not be bettered.
constexpr double kLongLived = 16.0;

// Vectors a and b with |a − b| ≤ |a| / 2 differ in direction by no more than this times |a − b| / |a|:
// 2 |a − b| / (|a| + |b|) bounds the chord.
constexpr double kTurn = 4.0 / 3.0 + 1e-9;

}  // namespace

FeatureCertificate::FeatureCertificate(const Mesh& a, const Mesh& b, const Placement& placement,
                                       const FeaturePairTest::Limits& limits, const MotionRate& rate,
                                       double reach)
    : a_{a, placement, false}, b_{b, placement, true}, limits_(limits), rate_(rate), reach_(reach) {}

Certificate FeatureCertificate::operator()(const TestedTriangle& a, const TestedTriangle& b) const {
  const double apart = distance_apart(a.shape, b.shape);
  if (apart > limits_.cutoff) return Certificate::within_distance(apart - limits_.cutoff - limits_.touch);
  Certificate all = Certificate::within_distance(apart - 2 * limits_.touch);
  all = both(all, corners_and_face(b_, b, a_, a));
  all = both(all, corners_and_face(a_, a, b_, b));
  all = both(all, faces(a, b));
  all = both(all, edges_and_face(b_, b, a_, a));
  all = both(all, edges_and_face(a_, a, b_, b));
  if (!all.holds()) return {};
  all = both(all, edges(a, b));
  if (!all.holds()) return {};
  all = both(all, corners_and_edges(b_, b, a_, a));
  all = both(all, corners_and_edges(a_, a, b_, b));
  return both(all, corners(a, b));
}

// A lower bound of the distance, at its best if it is likely to be used up soon; 0 if the triangles touch.
double FeatureCertificate::distance_apart(const Triangle& a, const Triangle& b) const {
  const double by_plane = std::max(plane_gap(a, b), certified_from_b(plane_gap(b, a), reach_));
  if (rate_.lifetime(Certificate::within_distance(by_plane)) >= kLongLived) return by_plane;
  const ClosestPoints closest = closest_points(a, b);
  return triangles_touch(a, b, closest, limits_.touch) ? 0.0 : std::sqrt(closest.squared_distance);
}

Certificate FeatureCertificate::corners_and_face(const MeshSide& corner_side, const TestedTriangle& corners,
                                                 const MeshSide& face_side,
                                                 const TestedTriangle& face) const {
  Certificate all{Certificate::kForever, Certificate::kForever};
  if (!corners.corners) return all;
  const Triangle& triangle = face.shape;
  const DVec3 normal = glm::normalize(triangle.area_vector());
  const bool two_sided = face_side.mesh.double_sided[face.index];
  for (int k = 0; k < 3; ++k) {
    if (!corners.has_corner(k)) continue;
    const DVec3& corner = corners.shape.corner[k];
    const double height = glm::dot(corner - triangle.corner[0], normal);
    double outside = std::max(std::abs(height) - limits_.cutoff, two_sided ? 0.0 : -height);
    for (int side = 0; side < 3; ++side) {
      const DVec3 along = triangle.along(side);
      const DVec3 away = glm::cross(along, normal) / glm::length(along);
      outside = std::max(outside, glm::dot(away, corner - triangle.start(side)));
    }
    Certificate one = seen_from(face_side, outside);
    if (rate_.lifetime(one) < kLongLived) {
      const Feature vertex = corner_side.vertex(corners, k);
      double lean = corner_side.violation(vertex, -normal);
      if (two_sided) lean = std::min(lean, corner_side.violation(vertex, normal));
      one = longer(one, Certificate::within_angle(lean - limits_.parallel_tolerance), rate_);
    }
    all = both(all, one);
  }
  return all;
}

// Until they are parallel.
Certificate FeatureCertificate::faces(const TestedTriangle& a, const TestedTriangle& b) const {
  const DVec3 normal_a = glm::normalize(a.shape.area_vector()),
              normal_b = glm::normalize(b.shape.area_vector());
  const double sine = glm::length(glm::cross(normal_a, normal_b)), cosine = -glm::dot(normal_a, normal_b);
  const bool two_sided = a_.mesh.double_sided[a.index] || b_.mesh.double_sided[b.index];
  const double angle = std::atan2(sine, two_sided ? std::abs(cosine) : cosine);
  return Certificate::within_angle(angle - 2 * limits_.parallel_tolerance);
}

// Until an edge is parallel to the face and holds its normal, or comes over it.
Certificate FeatureCertificate::edges_and_face(const MeshSide& edge_side, const TestedTriangle& edges,
                                               const MeshSide& face_side, const TestedTriangle& face) const {
  Certificate all{Certificate::kForever, Certificate::kForever};
  const DVec3 normal = glm::normalize(face.shape.area_vector());
  const bool two_sided = face_side.mesh.double_sided[face.index];
  for (int j = 0; j < 3; ++j) {
    if (!edges.has_side(j)) continue;
    const DVec3 &start = edges.shape.start(j), &end = edges.shape.end(j);
    const auto height = [&](const DVec3& point) { return glm::dot(normal, point - face.shape.corner[0]); };
    double outside = two_sided ? 0.0 : -std::max(height(start), height(end));
    for (int side = 0; side < 3; ++side) {
      const DVec3 along = face.shape.along(side);
      const DVec3 away = glm::cross(along, normal) / glm::length(along);
      outside = std::max(outside, std::min(glm::dot(away, start - face.shape.start(side)),
                                           glm::dot(away, end - face.shape.start(side))));
    }
    Certificate one = seen_from(face_side, outside);
    const double tilt = std::abs(glm::dot(normal, end - start)) / glm::length(end - start);
    one = longer(one, Certificate::within_angle(tilt - 2 * limits_.parallel_tolerance), rate_);
    if (rate_.lifetime(one) < kLongLived) {
      const Feature edge = edge_side.edge(edges, j);
      double lean = edge_side.violation(edge, -normal);
      if (two_sided) lean = std::min(lean, edge_side.violation(edge, normal));
      one = longer(one, Certificate::within_angle(lean - 2 * limits_.parallel_tolerance), rate_);
    }
    all = both(all, one);
  }
  return all;
}

Certificate FeatureCertificate::edges(const TestedTriangle& a, const TestedTriangle& b) const {
  Certificate all{Certificate::kForever, Certificate::kForever};
  for (int i = 0; i < 3; ++i) {
    if (!a.has_side(i)) continue;
    for (int j = 0; j < 3; ++j) {
      if (!b.has_side(j)) continue;
      const DVec3 u = a.shape.along(i), v = b.shape.along(j);
      const double lengths = glm::length(u) + glm::length(v);
      const DVec3 middles = b.shape.start(j) + 0.5 * v - a.shape.start(i) - 0.5 * u;
      Certificate one = Certificate::within_distance(glm::length(middles) - 0.5 * lengths - limits_.cutoff);
      if (rate_.lifetime(one) < kLongLived) one = longer(one, edge_pair(a, i, b, j), rate_);
      all = both(all, one);
    }
  }
  return all;
}

// Three facts, any of which will do: the common normal leans outside a polar cone; seen along it, the lines
// cross beyond an end of an edge; along it, they are farther apart than the cutoff.
Certificate FeatureCertificate::edge_pair(const TestedTriangle& a, int i, const TestedTriangle& b,
                                          int j) const {
  const DVec3 &start_a = a.shape.start(i), &start_b = b.shape.start(j);
  const double length_a = glm::length(a.shape.along(i)), length_b = glm::length(b.shape.along(j));
  const DVec3 u = a.shape.along(i) / length_a, v = b.shape.along(j) / length_b;
  const LinePair lines(start_a, u, start_b, v);
  const double sine = std::sqrt(lines.normal_squared);
  if (!(sine > 1e-6)) return {};
  const DVec3 normal = lines.normal / sine;
  const double place_a = std::clamp(lines.s, 0.0, length_a), place_b = std::clamp(lines.t, 0.0, length_b);
  const double beyond = std::max(std::abs(lines.s - place_a), std::abs(lines.t - place_b));
  const double height = std::abs(glm::dot(start_b - start_a, normal));
  const double slack = std::max(beyond * sine, height - limits_.cutoff) - 2 * limits_.touch;
  const double arm = glm::length(start_b + v * place_b - start_a - u * place_a);
  // As they become parallel, the lines cross anywhere.
  const Certificate across =
      sine < 4 * limits_.parallel_tolerance ? Certificate{} : across_normal(slack, arm, sine);
  if (rate_.lifetime(across) >= kLongLived) return across;
  return longer(across, common_normal_leaning(a_.edge(a, i), b_.edge(b, j), normal, sine), rate_);
}

// The common normal of two lines that turn by an angle of at most half the sine between them turns by no more
// than kTurn times that over the sine.
Certificate FeatureCertificate::common_normal_leaning(const Feature& edge_a, const Feature& edge_b,
                                                      const DVec3& normal, double sine) const {
  const double forward = std::max(a_.violation(edge_a, normal), b_.violation(edge_b, -normal));
  const double backward = std::max(a_.violation(edge_a, -normal), b_.violation(edge_b, normal));
  const double lean = std::min(forward, backward) - limits_.parallel_tolerance;
  return Certificate::within_angle(sine * std::min(lean / kTurn, 0.5));
}

// A distance between two points that is measured along, or at right angles to, the common normal: it changes
// by their motion, and by the turn of the direction at the end of an arm that grows meanwhile.
Certificate FeatureCertificate::across_normal(double slack, double arm, double sine) const {
  if (!(slack > 0)) return {};
  const double by_turn = (arm + slack) * (1.0 + kTurn / sine);
  const double share = rate_.distance / (rate_.distance + rate_.angle * by_turn);
  return {share * slack, std::min((1.0 - share) * slack / by_turn, 0.5 * sine)};
}

Certificate FeatureCertificate::corners_and_edges(const MeshSide& corner_side, const TestedTriangle& corners,
                                                  const MeshSide& edge_side,
                                                  const TestedTriangle& edges) const {
  Certificate all{Certificate::kForever, Certificate::kForever};
  if (!corners.corners) return all;
  for (int j = 0; j < 3; ++j) {
    if (!edges.has_side(j)) continue;
    const DVec3 along = edges.shape.along(j);
    const double length = glm::length(along);
    for (int k = 0; k < 3; ++k) {
      if (!corners.has_corner(k)) continue;
      const DVec3& corner = corners.shape.corner[k];
      const double place = glm::dot(corner - edges.shape.start(j), along) / length;
      const DVec3 between = corner - edges.shape.start(j) - along * (place / length);
      const double distance = glm::length(between);
      const double outside = std::max({-place, place - length, distance - limits_.cutoff});
      Certificate one = seen_from(edge_side, outside);
      if (rate_.lifetime(one) < kLongLived && distance > 0) {
        const DVec3 u = between / distance;
        const Feature edge = edge_side.edge(edges, j);
        const Feature vertex = corner_side.vertex(corners, k);
        const Certificate beside = seen_from(edge_side, lateral(edge_side.violation(edge, u), distance));
        const Certificate below =
            leaning_from_corner(corner_side, corner_side.violation(vertex, -u), distance);
        one = longer(one, longer(beside, below, rate_), rate_);
      }
      all = both(all, one);
    }
  }
  return all;
}

Certificate FeatureCertificate::corners(const TestedTriangle& a, const TestedTriangle& b) const {
  Certificate all{Certificate::kForever, Certificate::kForever};
  for (int i = 0; i < 3; ++i) {
    if (!a.has_corner(i)) continue;
    for (int j = 0; j < 3; ++j) {
      if (!b.has_corner(j)) continue;
      const DVec3 between = b.shape.corner[j] - a.shape.corner[i];
      const double distance = glm::length(between);
      Certificate one = Certificate::within_distance(distance - limits_.cutoff);
      if (rate_.lifetime(one) < kLongLived && distance > 0) {
        const DVec3 u = between / distance;
        one = longer(one, seen_from(a_, lateral(a_.violation(a_.vertex(a, i), u), distance)), rate_);
        one = longer(one, seen_from(b_, lateral(b_.violation(b_.vertex(b, j), -u), distance)), rate_);
      }
      all = both(all, one);
    }
  }
  return all;
}

Certificate FeatureCertificate::seen_from(const MeshSide& side, double slack) const {
  return Certificate::within_distance(side.is_b ? certified_from_b(slack, reach_) : slack);
}

// How far a point at `distance` may move, seen from a feature, until its direction leans outside the
// feature's polar cone no more: that far it is beyond one of the planes that bound the points of that cone.
double FeatureCertificate::lateral(double lean, double distance) const {
  return lean * distance - limits_.parallel_tolerance * limits_.cutoff - 2 * limits_.touch;
}

// The same of a corner's foot on an edge: it moves with the edge, and turns about the corner as the edge
// does.
Certificate FeatureCertificate::leaning_from_corner(const MeshSide& corner_side, double lean,
                                                    double distance) const {
  const double slack = lateral(lean, distance);
  if (!(slack > 0)) return {};
  const double by_turn = distance + slack;
  const double share = rate_.distance / (rate_.distance + rate_.angle * by_turn);
  Certificate certificate = seen_from(corner_side, share * slack);
  certificate.angle = (1.0 - share) * slack / by_turn;
  return certificate;
}

}  // namespace palpate
