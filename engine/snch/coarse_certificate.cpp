#include "engine/snch/coarse_certificate.h"

#include <algorithm>
#include <cmath>

#include "engine/kernel/line_pair.h"

namespace palpate {
namespace {

// Covers the rounding of a node's float32 bounds.
constexpr double kRounding = 4e-6;

// What the distance of parallel segments may be too large by, relative to their lengths.
constexpr double kParallel = 1e-7;

// The distance between two segments, or a little less: their parameters are noise where they are parallel.
double distance_between(const DVec3& p, const DVec3& u, const DVec3& q, const DVec3& v) {
  const DVec3 between = q - p;
  const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v);
  const double ub = glm::dot(u, between), vb = glm::dot(v, between), area = uu * vv - uv * uv;
  const SegmentPair closest((ub * vv - vb * uv) / area, between, u, v);
  return glm::length(between + closest.t * v - closest.s * u) - kParallel * (std::sqrt(uu) + std::sqrt(vv));
}

// The distance between a point and a segment, which may be a point.
double distance_to(const DVec3& point, const DVec3& p, const DVec3& u) {
  const DVec3 between = point - p;
  return glm::length(between - u * clamp_unit(glm::dot(between, u) / glm::dot(u, u)));
}

}  // namespace

struct CoarseCertificate::Bound {
  DVec3 centre;
  double radius;
  DVec3 axis;
  bool bounded;  // the cone is narrow
  double chord;  // from the cone's axis to its rim, at a distance of 1
};

CoarseCertificate::Bound CoarseCertificate::bound_of(const Node& node) const {
  const DVec3 centre(node.centre), axis(node.cone_axis);
  const double chord = std::sqrt(std::max(0.0, 2.0 - 2.0 * node.cone_cosine)) + kRounding;
  const bool bounded = node.cone_cosine > 0.5f;
  if (!fine_.is_b) return {centre, node.radius * (1.0 + kRounding), axis, bounded, chord};
  const Placement& placement = fine_.placement;
  return {placement.point(centre), placement.ratio * node.radius * (1.0 + kRounding),
          placement.rotation * axis, bounded, chord};
}

Certificate CoarseCertificate::operator()(const TestedTriangle& triangle, TrianglePlace place,
                                          const Node& node) const {
  const Bound fine = bound_of(node);
  if (place.is_corner()) return corner(triangle, place.code, fine);
  return place.is_side() ? side(triangle, place.side(), fine) : face(triangle, fine);
}

// What lies over it within the cutoff must face it.
Certificate CoarseCertificate::face(const TestedTriangle& triangle, const Bound& fine) const {
  const Triangle& shape = triangle.shape;
  const DVec3 normal = coarse_.normal(triangle);
  const bool two_sided = coarse_.mesh.double_sided[triangle.index];
  const double height = glm::dot(normal, fine.centre - shape.corner[0]);
  double outside = two_sided ? -HUGE_VAL : -height;
  for (int k = 0; k < 3; ++k) {
    const DVec3 along = shape.along(k);
    const DVec3 away = glm::cross(along, normal) / glm::length(along);
    outside =
        std::max(outside, glm::dot(away, fine.centre - shape.start(k)) -
                              features_.seam_at_side(coarse_, triangle, k, features_.includes_near_minima()));
  }
  const double slack = 2 * limits_.touch + fine.radius;
  const Certificate beyond =
      features_.seen_from(coarse_, std::max(outside, std::abs(height) - limits_.cutoff) - slack);
  if (!fine.bounded || two_sided || features_.is_long(beyond)) return beyond;
  const double apart = std::max(outside, std::abs(height)) - slack;
  const Certificate turned = Certificate::within_angle(glm::length(fine.axis + normal) - fine.chord -
                                                       4 * limits_.parallel_tolerance);
  return features_.better(beyond, both(turned, features_.seen_from(coarse_, apart)));
}

Certificate CoarseCertificate::side(const TestedTriangle& triangle, int k, const Bound& fine) const {
  const DVec3 &from = triangle.shape.start(k), &to = triangle.shape.end(k);
  // Where its line goes on, a near minimum may lie beyond an end.
  const bool is_near = triangle.has_near_side(k);
  const bool ends = features_.seam_at_ends(coarse_, triangle, k, limits_.cutoff, is_near) == 0.0;
  const Certificate near = ends ? along_cone(from, to, fine) : Certificate{};
  if (!fine.bounded || features_.is_long(near)) return near;
  // Directions at right angles to the side.
  const DVec3 along = glm::normalize(to - from);
  const Certificate across = Certificate::within_angle(std::abs(glm::dot(fine.axis, along)) - fine.chord -
                                                       4 * limits_.parallel_tolerance);
  if (features_.is_long(across)) return across;
  const Certificate lean = leaning(coarse_.edge(triangle, k), fine, is_near);
  return features_.better(near, features_.better(across, lean));
}

Certificate CoarseCertificate::corner(const TestedTriangle& triangle, int k, const Bound& fine) const {
  const DVec3& corner = triangle.shape.corner[k];
  const Certificate near = along_cone(corner, corner, fine);
  if (!fine.bounded || features_.is_long(near)) return near;
  return features_.better(near, leaning(coarse_.vertex(triangle, k), fine, triangle.has_near_corner(k)));
}

// A segment is out of reach, or not where the directions of the fine model lead.
Certificate CoarseCertificate::along_cone(const DVec3& from, const DVec3& to, const Bound& fine) const {
  const double slack = fine.radius + 2 * limits_.touch;
  const double apart = distance_to(fine.centre, from, to - from);
  const Certificate far = Certificate::within_distance(apart - slack - limits_.cutoff);
  if (far.holds() || !fine.bounded) return far;
  const DVec3 sweep = limits_.cutoff * fine.axis;
  const double beside = from == to ? distance_to(from, fine.centre, sweep)
                                   : distance_between(from, to - from, fine.centre, sweep);
  return features_.seen_from(fine_, beside - slack - limits_.cutoff * (fine.chord + kRounding));
}

// All directions of the fine model lean outside the polar cone of a side or corner.
Certificate CoarseCertificate::leaning(const Feature& feature, const Bound& fine, bool near) const {
  const double beyond = features_.beyond(coarse_, feature, -fine.axis, near);
  return Certificate::within_angle(beyond - fine.chord - 4 * limits_.parallel_tolerance);
}

}  // namespace palpate
