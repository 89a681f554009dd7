#include "tests/kernel/exact_pair.h"

#include <algorithm>
#include <limits>

namespace palpate::exact {
namespace {

Real clamp_unit(Real x) {
  return x > 0 ? std::min(x, Real(1)) : Real(0);
}

Real3 nearest_on_segment(const Real3& point, const Real3& from, const Real3& to) {
  const Real3 along = to - from;
  return from + along * clamp_unit(glm::dot(point - from, along) / glm::dot(along, along));
}

// Relative to a corner, so that nothing is lost far from the origin.
struct Corners {
  Real3 at[3];

  Corners(const Triangle& triangle, const DVec3& origin) {
    for (int k = 0; k < 3; ++k) at[k] = real(triangle.corner[k]) - real(origin);
  }
};

// The foot in the plane if it is inside, by the areas that it makes with the sides; else on the rim.
Real3 nearest_on_triangle(const Real3& point, const Corners& triangle) {
  const Real3(&at)[3] = triangle.at;
  Real3 best = at[0];
  for (int k = 0; k < 3; ++k) {
    const Real3 on_side = nearest_on_segment(point, at[k], at[(k + 1) % 3]);
    if (glm::length(point - on_side) < glm::length(point - best)) best = on_side;
  }
  const Real3 area = glm::cross(at[1] - at[0], at[2] - at[0]);
  const Real squared = glm::dot(area, area);
  Real part[3];
  for (int k = 0; k < 3; ++k)
    part[k] =
        glm::dot(glm::cross(at[(k + 2) % 3] - at[(k + 1) % 3], point - at[(k + 1) % 3]), area) / squared;
  if (!(part[0] >= 0 && part[1] >= 0 && part[2] >= 0)) return best;
  const Real3 foot = (part[0] * at[0] + part[1] * at[1] + part[2] * at[2]) / (part[0] + part[1] + part[2]);
  return glm::length(point - foot) < glm::length(point - best) ? foot : best;
}

// Where the lines come closest, then in turn onto each segment.
void nearest_on_segments(const Real3& p, const Real3& u, const Real3& q, const Real3& v, Real3& on_first,
                         Real3& on_second) {
  const Real3 normal = glm::cross(u, v);
  const Real s = clamp_unit(glm::dot(glm::cross(q - p, v), normal) / glm::dot(normal, normal));
  on_second = nearest_on_segment(p + s * u, q, q + v);
  on_first = nearest_on_segment(on_second, p, p + u);
}

}  // namespace

Real distance_to_segment(const Real3& point, const Real3& from, const Real3& to) {
  return glm::length(point - nearest_on_segment(point, from, to));
}

Real distance_to_triangle(const Real3& point, const Triangle& triangle) {
  const Real3 local = point - real(triangle.corner[0]);
  return glm::length(local - nearest_on_triangle(local, Corners(triangle, triangle.corner[0])));
}

Distance distance(const Triangle& first, const Triangle& second) {
  const Corners a(first, first.corner[0]), b(second, first.corner[0]);
  Real best = std::numeric_limits<Real>::infinity();
  Real3 way(0);
  const auto consider = [&](const Real3& on_a, const Real3& on_b) {
    if (glm::length(on_b - on_a) >= best) return;
    way = on_b - on_a;
    best = glm::length(way);
  };
  for (int i = 0; i < 3; ++i) {
    consider(a.at[i], nearest_on_triangle(a.at[i], b));
    consider(nearest_on_triangle(b.at[i], a), b.at[i]);
    for (int j = 0; j < 3; ++j) {
      Real3 on_a, on_b;
      nearest_on_segments(a.at[i], a.at[(i + 1) % 3] - a.at[i], b.at[j], b.at[(j + 1) % 3] - b.at[j], on_a,
                          on_b);
      consider(on_a, on_b);
    }
  }
  Real high_a = -std::numeric_limits<Real>::infinity(), low_b = std::numeric_limits<Real>::infinity();
  for (int k = 0; k < 3; ++k) {
    high_a = std::max(high_a, glm::dot(a.at[k], way / best));
    low_b = std::min(low_b, glm::dot(b.at[k], way / best));
  }
  return {best, low_b - high_a};
}

}  // namespace palpate::exact
