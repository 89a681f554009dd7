#include "engine/snch/feature_certificate.h"

#include <algorithm>
#include <cmath>

#include "engine/kernel/line_pair.h"
#include "engine/kernel/triangle_pair.h"
#include "engine/snch/near_minima.h"

namespace palpate {
namespace {

// Vectors a and b with |a − b| ≤ |a| / 2 differ in direction by no more than this times |a − b| / |a|:
// 2 |a − b| / (|a| + |b|) bounds the chord.
constexpr double kTurn = 4.0 / 3.0 + 1e-9;

}  // namespace

FeatureCertificate::FeatureCertificate(const Mesh& a, const Mesh& b, const Placement& placement,
                                       const FeaturePairTest::Limits& limits, const MotionRate& rate,
                                       double reach)
    : a_{a, placement, false}, b_{b, placement, true}, limits_(limits), rate_(rate), reach_(reach) {}

Certificate FeatureCertificate::operator()(const TestedTriangle& a, const TestedTriangle& b,
                                           FeaturePairSet among, bool apart,
                                           PairCertificates& certificates) const {
  certificates.clear(apart);
  if (among.has(FeaturePairSet::kContact)) {
    const double distance = distance_apart(a.shape, b.shape);
    const Certificate far = Certificate::within_distance(distance - limits_.cutoff - limits_.touch);
    if (far.holds()) return far;
    const Certificate apart_still = Certificate::within_distance(distance - close());
    certificates.clear(apart && apart_still.holds());
    certificates.set(FeaturePairSet::kContact, apart_still);
  }
  MeasuredTriangle of_a(a_, a), of_b(b_, b);
  if (among.has(FeaturePairSet::kFaces)) certificates.set(FeaturePairSet::kFaces, faces(of_a, of_b));
  corners_and_face(of_b, of_a, among, certificates);
  corners_and_face(of_a, of_b, among, certificates);
  edges_and_face(of_b, of_a, among, certificates);
  edges_and_face(of_a, of_b, among, certificates);
  edges(of_a, of_b, among, certificates);
  corners_and_edges(of_b, of_a, among, certificates);
  corners_and_edges(of_a, of_b, among, certificates);
  corners(of_a, of_b, among, certificates);
  return {};
}

// A lower bound of the distance, at its best if it is likely to be used up soon; 0 if the triangles touch.
double FeatureCertificate::distance_apart(const Triangle& a, const Triangle& b) const {
  const double by_plane = std::max(plane_gap(a, b), certified_from_b(plane_gap(b, a), reach_));
  if (is_long(Certificate::within_distance(by_plane))) return by_plane;
  const ClosestPoints closest = closest_points(a, b);
  return triangles_touch(a, b, closest, limits_.touch) ? 0.0 : std::sqrt(closest.squared_distance);
}

void FeatureCertificate::corners_and_face(const MeasuredTriangle& corners, const MeasuredTriangle& face,
                                          FeaturePairSet among, PairCertificates& to) const {
  const TestedTriangle& tested = corners.tested();
  const bool is_b = corners.side().is_b;
  if (!(tested.corners | tested.near_corners) || !among.has_any(FeaturePairSet::corner_and_face(is_b, 0), 3))
    return;
  const DVec3& normal = face.normal();
  for (int k = 0; k < 3; ++k) {
    const int pair = FeaturePairSet::corner_and_face(is_b, k);
    const bool near = tested.has_near_corner(k);
    if ((!near && !tested.has_corner(k)) || !among.has(pair)) continue;
    const DVec3& corner = corners.shape().corner[k];
    const double height = glm::dot(corner - face.shape().corner[0], normal);
    double outside = std::max(std::abs(height) - limits_.cutoff, face.two_sided() ? 0.0 : -height);
    for (int side = 0; side < 3; ++side)
      outside = std::max(outside, glm::dot(face.away(side), corner - face.shape().start(side)) -
                                      seam_at_side(face.side(), face.tested(), side, near));
    Certificate one = seen_from(face.side(), outside);
    if (!is_long(one)) {
      const Feature vertex = corners.vertex(k);
      double outside_cone = beyond(corners.side(), vertex, -normal, near);
      if (face.two_sided())
        outside_cone = std::min(outside_cone, beyond(corners.side(), vertex, normal, near));
      one = longer(one, Certificate::within_angle(outside_cone), rate_);
    }
    to.set(pair, one);
  }
}

// Until they are parallel. A chord is no longer than its arc.
Certificate FeatureCertificate::faces(const MeasuredTriangle& a, const MeasuredTriangle& b) const {
  double apart = glm::length(a.normal() + b.normal());
  if (a.two_sided() || b.two_sided()) apart = std::min(apart, glm::length(a.normal() - b.normal()));
  return Certificate::within_angle(apart - 2 * limits_.parallel_tolerance);
}

// Until an edge is parallel to the face and holds its normal, or comes over it.
void FeatureCertificate::edges_and_face(MeasuredTriangle& edges, const MeasuredTriangle& face,
                                        FeaturePairSet among, PairCertificates& to) const {
  const bool is_b = edges.side().is_b;
  if (!among.has_any(FeaturePairSet::edge_and_face(is_b, 0), 3)) return;
  const DVec3& normal = face.normal();
  for (int j = 0; j < 3; ++j) {
    const int pair = FeaturePairSet::edge_and_face(is_b, j);
    if (!edges.tested().has_side(j) || !among.has(pair)) continue;
    const DVec3 &start = edges.shape().start(j), &end = edges.shape().end(j);
    const auto height = [&](const DVec3& point) { return glm::dot(normal, point - face.shape().corner[0]); };
    double outside = face.two_sided() ? 0.0 : -std::max(height(start), height(end));
    for (int side = 0; side < 3; ++side) {
      const DVec3 away = face.away(side);
      outside = std::max(outside, std::min(glm::dot(away, start - face.shape().start(side)),
                                           glm::dot(away, end - face.shape().start(side))));
    }
    Certificate one = seen_from(face.side(), outside);
    const double tilt = std::abs(glm::dot(normal, edges.along(j)));
    one = longer(one, Certificate::within_angle(tilt - 2 * limits_.parallel_tolerance), rate_);
    if (!is_long(one)) {
      double lean = beyond_edge(edges, j, -normal, false);
      if (face.two_sided()) lean = std::min(lean, beyond_edge(edges, j, normal, false));
      one = longer(one, Certificate::within_angle(lean - limits_.parallel_tolerance), rate_);
    }
    to.set(pair, one);
  }
}

void FeatureCertificate::edges(MeasuredTriangle& a, MeasuredTriangle& b, FeaturePairSet among,
                               PairCertificates& to) const {
  if (!among.has_any(FeaturePairSet::edges(0, 0), 9)) return;
  const TestedTriangle &of_a = a.tested(), &of_b = b.tested();
  for (int i = 0; i < 3; ++i) {
    if (!of_a.has_side(i) && !of_a.has_near_side(i)) continue;
    for (int j = 0; j < 3; ++j) {
      const bool near = of_a.has_near_side(i) && of_b.has_near_side(j);
      const int pair = FeaturePairSet::edges(i, j);
      if ((!near && !(of_a.has_side(i) && of_b.has_side(j))) || !among.has(pair)) continue;
      const DVec3 middles =
          0.5 * (b.shape().start(j) + b.shape().end(j) - a.shape().start(i) - a.shape().end(i));
      const double lengths = a.length(i) + b.length(j);
      Certificate one = Certificate::within_distance(glm::length(middles) - 0.5 * lengths - limits_.cutoff);
      if (!is_long(one) && !near) one = longer(one, arcs_apart(a, i, b, j), rate_);
      if (!is_long(one)) one = longer(one, edge_pair(a, i, b, j, near), rate_);
      to.set(pair, one);
    }
  }
}

// No direction at right angles to the one edge is in the polar cone of the other.
Certificate FeatureCertificate::arcs_apart(MeasuredTriangle& a, int i, MeasuredTriangle& b, int j) const {
  const double beside = std::max(b.arc(j).beside(a.along(i)), a.arc(i).beside(b.along(j)));
  return Certificate::within_angle(beside - 4 * limits_.parallel_tolerance);
}

// Edges that are nearly parallel may hold a cell of a plateau, and cross anywhere as they turn. For others
// three facts, any of which will do: the common normal leans outside a polar cone; seen along it, the lines
// cross beyond an end of an edge; along it, they are farther apart than the cutoff.
Certificate FeatureCertificate::edge_pair(MeasuredTriangle& a, int i, MeasuredTriangle& b, int j,
                                          bool near) const {
  const DVec3 &start_a = a.shape().start(i), &start_b = b.shape().start(j);
  const DVec3 &u = a.along(i), &v = b.along(j);
  const LinePair lines(start_a, u, start_b, v);
  const double sine = std::sqrt(lines.normal_squared);
  if (!(sine > 4 * limits_.parallel_tolerance)) return {};
  const DVec3 normal = lines.normal / sine;
  const double place_a = std::clamp(lines.s, 0.0, a.length(i)),
               place_b = std::clamp(lines.t, 0.0, b.length(j));
  // While the certificate holds, the sine stays above half of what it is.
  const double stretched = 4 * limits_.cutoff / (sine * sine);
  const double past_end =
      std::max(std::abs(lines.s - place_a) - seam_at_ends(a_, a.tested(), i, stretched, near),
               std::abs(lines.t - place_b) - seam_at_ends(b_, b.tested(), j, stretched, near));
  const double height = std::abs(glm::dot(start_b - start_a, normal));
  const double slack = std::max(past_end * sine, height - limits_.cutoff) - 2 * limits_.touch;
  const double arm = glm::length(start_b + v * place_b - start_a - u * place_a);
  const Certificate across = across_normal(slack, arm, sine);
  if (is_long(across)) return across;
  return longer(across, common_normal_leaning(a, i, b, j, normal, sine, near), rate_);
}

// The common normal of two lines that turn by an angle of at most half the sine between them turns by no more
// than kTurn times that over the sine.
Certificate FeatureCertificate::common_normal_leaning(MeasuredTriangle& a, int i, MeasuredTriangle& b, int j,
                                                      const DVec3& normal, double sine, bool near) const {
  const double forward = std::max(beyond_edge(a, i, normal, near), beyond_edge(b, j, -normal, near));
  const double backward = std::max(beyond_edge(a, i, -normal, near), beyond_edge(b, j, normal, near));
  return Certificate::within_angle(sine * std::min(std::min(forward, backward) / kTurn, 0.5));
}

// A distance between two points that is measured along, or at right angles to, the common normal: it changes
// by their motion, and by the turn of the direction at the end of an arm that grows meanwhile.
Certificate FeatureCertificate::across_normal(double slack, double arm, double sine) const {
  if (!(slack > 0)) return {};
  const double by_turn = (arm + slack) * (1.0 + kTurn / sine);
  const double share = rate_.distance() / (rate_.distance() + rate_.angle() * by_turn);
  return {share * slack, std::min((1.0 - share) * slack / by_turn, 0.5 * sine)};
}

void FeatureCertificate::corners_and_edges(const MeasuredTriangle& corners, MeasuredTriangle& edges,
                                           FeaturePairSet among, PairCertificates& to) const {
  const TestedTriangle &of_corners = corners.tested(), &of_edges = edges.tested();
  const bool is_b = corners.side().is_b;
  if (!among.has_any(FeaturePairSet::corner_and_edge(is_b, 0, 0), 9)) return;
  for (int j = 0; j < 3; ++j) {
    if (!of_edges.has_side(j) && !of_edges.has_near_side(j)) continue;
    for (int k = 0; k < 3; ++k) {
      const bool near = of_edges.has_near_side(j) && of_corners.has_near_corner(k);
      const int pair = FeaturePairSet::corner_and_edge(is_b, k, j);
      if ((!near && !(of_edges.has_side(j) && of_corners.has_corner(k))) || !among.has(pair)) continue;
      to.set(pair, corner_and_edge(corners, k, edges, j, near, to.apart()));
    }
  }
}

// `apart`: while the triangles are. Else a direction is only as sure as its points are distant.
Certificate FeatureCertificate::corner_and_edge(const MeasuredTriangle& corners, int k,
                                                MeasuredTriangle& edges, int j, bool near, bool apart) const {
  const DVec3& along = edges.along(j);
  const DVec3 from_start = corners.shape().corner[k] - edges.shape().start(j);
  const double place = glm::dot(from_start, along), length = edges.length(j);
  const DVec3 between = from_start - along * place;
  const double distance = glm::length(between);
  const double past_end =
      std::max(-place, place - length) - seam_at_ends(edges.side(), edges.tested(), j, limits_.cutoff, near);
  Certificate one = seen_from(edges.side(), std::max(past_end, distance - limits_.cutoff));
  if (is_long(one) || !(distance > 0)) return one;
  const Feature vertex = corners.vertex(k);
  if (!near) {
    const double lean = edges.arc(j).beyond(corners.side(), vertex);
    const Certificate turn = Certificate::within_angle(lean - 4 * limits_.parallel_tolerance);
    one = longer(one, apart ? turn : both(turn, seen_from(edges.side(), distance - close())), rate_);
    if (is_long(one)) return one;
  }
  const DVec3 u = between / distance;
  const Certificate beside = seen_from(edges.side(), lateral(beyond_edge(edges, j, u, near), distance));
  const Certificate below =
      leaning_from_corner(corners.side(), beyond(corners.side(), vertex, -u, near), distance);
  return longer(one, longer(beside, below, rate_), rate_);
}

void FeatureCertificate::corners(const MeasuredTriangle& a, const MeasuredTriangle& b, FeaturePairSet among,
                                 PairCertificates& to) const {
  if (!among.has_any(FeaturePairSet::corners(0, 0), 9)) return;
  const TestedTriangle &of_a = a.tested(), &of_b = b.tested();
  for (int i = 0; i < 3; ++i) {
    if (!of_a.has_corner(i) && !of_a.has_near_corner(i)) continue;
    for (int j = 0; j < 3; ++j) {
      const bool near = of_a.has_near_corner(i) && of_b.has_near_corner(j);
      const int pair = FeaturePairSet::corners(i, j);
      if ((!near && !(of_a.has_corner(i) && of_b.has_corner(j))) || !among.has(pair)) continue;
      const DVec3 between = of_b.shape.corner[j] - of_a.shape.corner[i];
      const double distance = glm::length(between);
      Certificate one = Certificate::within_distance(distance - limits_.cutoff);
      if (!is_long(one) && distance > 0) {
        const DVec3 u = between / distance;
        one = longer(one, seen_from(a_, lateral(beyond(a_, a.vertex(i), u, near), distance)), rate_);
        one = longer(one, seen_from(b_, lateral(beyond(b_, b.vertex(j), -u, near), distance)), rate_);
      }
      to.set(pair, one);
    }
  }
}

// beyond() an edge that a triangle owns, for a `u` at right angles to it.
double FeatureCertificate::beyond_edge(MeasuredTriangle& edges, int k, const DVec3& u, bool near) const {
  if (near || !edges.arc(k).bounded) return beyond(edges.side(), edges.edge(k), u, near);
  return edges.arc(k).violation(u) - limits_.parallel_tolerance;
}

double FeatureCertificate::beyond(const MeshSide& side, const Feature& feature, const DVec3& u,
                                  bool near) const {
  return near ? NearPolar(side, creases(side)).beyond(feature, u)
              : side.violation(feature, u) - limits_.parallel_tolerance;
}

double FeatureCertificate::seam_at_side(const MeshSide& side, const TestedTriangle& t, int k,
                                        bool near) const {
  if (!near || !creases(side).is_flat(side.mesh.triangle_edges[t.index][k])) return 0.0;
  return NearMinimumTest::seam(glm::length(t.shape.along(k)), limits_.cutoff);
}

double FeatureCertificate::seam_at_ends(const MeshSide& side, const TestedTriangle& t, int k, double distance,
                                        bool near) const {
  if (!near) return 0.0;
  const TriangleIndices& corners = side.mesh.triangles[t.index];
  if (!creases(side).is_straight(corners[k]) && !creases(side).is_straight(corners[(k + 1) % 3])) return 0.0;
  return NearMinimumTest::seam(glm::length(t.shape.along(k)), distance);
}

Certificate FeatureCertificate::seen_from(const MeshSide& side, double slack) const {
  return Certificate::within_distance(side.is_b ? certified_from_b(slack, reach_) : slack);
}

// How far a point at `distance` may move, seen from a feature, until its direction leans outside the
// feature's polar cone no more: that far it is beyond one of the planes that bound the points of that cone.
double FeatureCertificate::lateral(double beyond, double distance) const {
  return beyond * distance - limits_.parallel_tolerance * limits_.cutoff - 2 * limits_.touch;
}

// The same of a corner's foot on an edge: it moves with the edge, and turns about the corner as the edge
// does.
Certificate FeatureCertificate::leaning_from_corner(const MeshSide& corner_side, double beyond,
                                                    double distance) const {
  const double slack = lateral(beyond, distance);
  if (!(slack > 0)) return {};
  const double by_turn = distance + slack;
  const double share = rate_.distance() / (rate_.distance() + rate_.angle() * by_turn);
  Certificate certificate = seen_from(corner_side, share * slack);
  certificate.angle = (1.0 - share) * slack / by_turn;
  return certificate;
}

}  // namespace palpate
