#include "tests/oracle/closest.h"

#include <algorithm>
#include <cmath>

namespace palpate::oracle {
namespace {

DVec3 normal_of(const Corners& c) {
  return glm::cross(c.at[1] - c.at[0], c.at[2] - c.at[0]);
}

// Segment parameters by the dot form (Ericson 2005, 5.1.9), another way than the engine's.
std::pair<double, double> closest_parameters(const DVec3& p, const DVec3& u, const DVec3& q, const DVec3& v) {
  const DVec3 r = p - q;
  const double a = glm::dot(u, u), e = glm::dot(v, v), f = glm::dot(v, r), c = glm::dot(u, r),
               b = glm::dot(u, v);
  const double determinant = a * e - b * b;
  double s = determinant > 1e-18 * a * e ? std::clamp((b * f - c * e) / determinant, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0.0) {
    t = 0.0;
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1.0) {
    t = 1.0;
    s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  return {s, t};
}

Place place_on_side(const Surface& surface, TriangleIndex t, int side, double parameter) {
  if (parameter <= 0.0) return {0, surface.triangles[t][side]};
  if (parameter >= 1.0) return {0, surface.triangles[t][(side + 1) % 3]};
  return {1, surface.edge(t, side)};
}

double margin_on_side(double parameter, double length) {
  return parameter <= 0.0 || parameter >= 1.0 ? 1e300 : std::min(parameter, 1.0 - parameter) * length;
}

// Distance of the foot of `point` inside the triangle from its rim; negative outside.
double depth_inside(const Corners& face, const DVec3& unit_normal, const DVec3& point) {
  double depth = 1e300;
  for (int k = 0; k < 3; ++k) {
    const DVec3 side = face.at[(k + 1) % 3] - face.at[k];
    depth = std::min(depth, glm::dot(glm::cross(unit_normal, side), point - face.at[k]) / glm::length(side));
  }
  return depth;
}

bool pierces(const DVec3& from, const DVec3& to, const Corners& face) {
  const DVec3 normal = glm::normalize(normal_of(face));
  const double start = glm::dot(from - face.at[0], normal), end = glm::dot(to - face.at[0], normal);
  if (start * end > 0 || start == end) return false;
  return depth_inside(face, normal, from + (to - from) * (start / (start - end))) >= 0;
}

}  // namespace

Closest closest(const Surface& a, TriangleIndex in_a, const Corners& corners_a, const Surface& b,
                TriangleIndex in_b, const Corners& corners_b) {
  Closest best{1e300, {}, {}, {}, {}, 0.0};
  const auto consider = [&](const DVec3& p, const DVec3& q, Place place_a, Place place_b, double margin) {
    const double distance = glm::length(q - p);
    if (distance < best.distance) best = {distance, p, q, place_a, place_b, margin};
  };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const DVec3 u = corners_a.at[(i + 1) % 3] - corners_a.at[i],
                  v = corners_b.at[(j + 1) % 3] - corners_b.at[j];
      const auto [s, t] = closest_parameters(corners_a.at[i], u, corners_b.at[j], v);
      consider(corners_a.at[i] + s * u, corners_b.at[j] + t * v, place_on_side(a, in_a, i, s),
               place_on_side(b, in_b, j, t),
               std::min(margin_on_side(s, glm::length(u)), margin_on_side(t, glm::length(v))));
    }
  const DVec3 normal_a = glm::normalize(normal_of(corners_a)),
              normal_b = glm::normalize(normal_of(corners_b));
  for (int k = 0; k < 3; ++k) {
    const DVec3 &p = corners_a.at[k], &q = corners_b.at[k];
    const double over_a = depth_inside(corners_a, normal_a, q), over_b = depth_inside(corners_b, normal_b, p);
    if (over_a > 0)
      consider(q - normal_a * glm::dot(q - corners_a.at[0], normal_a), q, {2, in_a},
               {0, b.triangles[in_b][k]}, over_a);
    if (over_b > 0)
      consider(p, p - normal_b * glm::dot(p - corners_b.at[0], normal_b), {0, a.triangles[in_a][k]},
               {2, in_b}, over_b);
  }
  return best;
}

bool crossing(const Corners& a, const Corners& b) {
  for (int k = 0; k < 3; ++k)
    if (pierces(a.at[k], a.at[(k + 1) % 3], b) || pierces(b.at[k], b.at[(k + 1) % 3], a)) return true;
  return false;
}

}  // namespace palpate::oracle
