#include "tests/stress/exact_triangles.h"

#include <utility>

namespace palpate::stress {
namespace {

constexpr double kFar = 1e300;

Real clamped(Real x) {
  return x > 0 ? (x < 1 ? x : Real(1)) : Real(0);
}

// Parameters of the closest points of p + s·u and q + t·v, in cross form.
std::pair<Real, Real> closest_parameters(const RVec3& p, const RVec3& u, const RVec3& q, const RVec3& v) {
  const RVec3 between = q - p, normal = cross(u, v);
  const Real normal_squared = dot(normal, normal);
  Real s = normal_squared > 0 ? clamped(dot(cross(between, v), normal) / normal_squared) : Real(0);
  const Real t = clamped((s * dot(u, v) - dot(between, v)) / dot(v, v));
  s = clamped((t * dot(u, v) + dot(between, u)) / dot(u, u));
  return {s, t};
}

int place_on_side(int side, Real parameter) {
  return parameter <= 0 ? side : parameter >= 1 ? (side + 1) % 3 : 3 + side;
}

Real margin_on_side(Real parameter, Real side) {
  return parameter <= 0 || parameter >= 1 ? Real(kFar) : std::min(parameter, 1 - parameter) * side;
}

// How far the foot of a point is inside the triangle's rim; negative outside.
Real depth_inside(const ExactTriangle& face, const RVec3& unit_normal, const RVec3& point) {
  Real depth = kFar;
  for (int side = 0; side < 3; ++side) {
    const RVec3 along = face.along(side);
    depth = std::min(depth, dot(cross(unit_normal, along), point - face.start(side)) / length(along));
  }
  return depth;
}

bool pierces(const RVec3& from, const RVec3& to, const ExactTriangle& face) {
  const RVec3 area = face.area();
  const Real start = dot(from - face.corner[0], area), end = dot(to - face.corner[0], area);
  if ((start > 0 && end > 0) || (start < 0 && end < 0) || start == end) return false;
  return depth_inside(face, unit(area), from + (to - from) * (start / (start - end))) >= 0;
}

bool on_one_side(const ExactTriangle& plane, const ExactTriangle& other) {
  const RVec3 area = plane.area();
  int above = 0, below = 0;
  for (const RVec3& corner : other.corner) {
    const Real height = dot(corner - plane.corner[0], area);
    above += height > 0;
    below += height < 0;
  }
  return above == 3 || below == 3;
}

}  // namespace

bool exact_crossing(const ExactTriangle& a, const ExactTriangle& b) {
  if (on_one_side(a, b) || on_one_side(b, a)) return false;
  for (int k = 0; k < 3; ++k)
    if (pierces(a.corner[k], a.corner[(k + 1) % 3], b) || pierces(b.corner[k], b.corner[(k + 1) % 3], a))
      return true;
  return false;
}

ExactClosest exact_closest(const ExactTriangle& a, const ExactTriangle& b) {
  ExactClosest best{kFar, {}, {}, 0, 0, 0};
  const auto consider = [&](const RVec3& p, const RVec3& q, int place_a, int place_b, Real margin) {
    const Real squared = dot(q - p, q - p);
    if (squared < best.distance) best = {squared, p, q, place_a, place_b, margin};
  };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const RVec3 u = a.along(i), v = b.along(j);
      const auto [s, t] = closest_parameters(a.start(i), u, b.start(j), v);
      consider(a.start(i) + u * s, b.start(j) + v * t, place_on_side(i, s), place_on_side(j, t),
               std::min(margin_on_side(s, length(u)), margin_on_side(t, length(v))));
    }
  const RVec3 normal_a = unit(a.area()), normal_b = unit(b.area());
  for (int k = 0; k < 3; ++k) {
    const RVec3 &p = a.corner[k], &q = b.corner[k];
    const Real over_a = depth_inside(a, normal_a, q), over_b = depth_inside(b, normal_b, p);
    if (over_a > 0) consider(q - normal_a * dot(q - a.corner[0], normal_a), q, 6, k, over_a);
    if (over_b > 0) consider(p, p - normal_b * dot(p - b.corner[0], normal_b), k, 6, over_b);
  }
  best.distance = exact_crossing(a, b) ? Real(0) : sqrtq(best.distance);
  return best;
}

}  // namespace palpate::stress
