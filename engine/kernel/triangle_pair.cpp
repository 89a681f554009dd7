#include "engine/kernel/triangle_pair.h"

#include <algorithm>
#include <limits>

#include "engine/kernel/line_pair.h"

namespace palpate {
namespace {

void keep_closer(ClosestPoints& best, const DVec3& on_first, const DVec3& on_second,
                 TrianglePlace first_place, TrianglePlace second_place) {
  const DVec3 between = on_second - on_first;
  const double squared = glm::dot(between, between);
  if (squared < best.squared_distance) best = {squared, on_first, on_second, first_place, second_place};
}

TrianglePlace place_on_side(int side, double parameter) {
  const int code = parameter <= 0.0 ? side : parameter >= 1.0 ? (side + 1) % 3 : 3 + side;
  return {static_cast<std::uint8_t>(code)};
}

void compare_sides(ClosestPoints& best, const Triangle& first, int i, const Triangle& second, int j) {
  const DVec3 u = first.along(i), v = second.along(j);
  const LinePair lines(first.start(i), u, second.start(j), v);
  const SegmentPair sides(lines.s, second.start(j) - first.start(i), u, v);
  keep_closer(best, first.start(i) + sides.s * u, second.start(j) + sides.t * v, place_on_side(i, sides.s),
              place_on_side(j, sides.t));
}

// The foot of `point` in the plane of `triangle` lies inside the triangle.
bool over_face(const Triangle& triangle, const DVec3& area, const DVec3& point) {
  for (int side = 0; side < 3; ++side)
    if (glm::dot(glm::cross(area, triangle.along(side)), point - triangle.start(side)) < 0) return false;
  return true;
}

void compare_corners(ClosestPoints& best, const Triangle& face, const Triangle& corners, bool swapped) {
  const DVec3 area = face.area_vector();
  const double area_squared = glm::dot(area, area);
  if (!(area_squared > 0)) return;
  const TrianglePlace on_face{TrianglePlace::kFace};
  for (std::uint8_t k = 0; k < 3; ++k) {
    const DVec3& corner = corners.corner[k];
    if (!over_face(face, area, corner)) continue;
    const DVec3 foot = corner - area * (glm::dot(corner - face.corner[0], area) / area_squared);
    swapped ? keep_closer(best, corner, foot, {k}, on_face) : keep_closer(best, foot, corner, on_face, {k});
  }
}

bool side_pierces(const DVec3& from, const DVec3& to, const Triangle& triangle, const DVec3& area) {
  const double above = glm::dot(from - triangle.corner[0], area);
  const double below = glm::dot(to - triangle.corner[0], area);
  if ((above > 0 && below > 0) || (above < 0 && below < 0)) return false;
  if (above == 0 && below == 0) return over_face(triangle, area, from) || over_face(triangle, area, to);
  return over_face(triangle, area, from + (to - from) * (above / (above - below)));
}

bool any_side_pierces(const Triangle& sides, const Triangle& triangle) {
  const DVec3 area = triangle.area_vector();
  for (int side = 0; side < 3; ++side)
    if (side_pierces(sides.start(side), sides.end(side), triangle, area)) return true;
  return false;
}

}  // namespace

ClosestPoints closest_points(const Triangle& first, const Triangle& second) {
  ClosestPoints best{std::numeric_limits<double>::infinity(), first.corner[0], second.corner[0], {0}, {0}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) compare_sides(best, first, i, second, j);
  compare_corners(best, first, second, false);
  compare_corners(best, second, first, true);
  return best;
}

double plane_gap(const Triangle& first, const Triangle& second) {
  const DVec3 area = first.area_vector();
  const auto height = [&](int k) { return glm::dot(second.corner[k] - first.corner[0], area); };
  const double low = std::min({height(0), height(1), height(2)}),
               high = std::max({height(0), height(1), height(2)});
  return std::max({low, -high, 0.0}) / glm::length(area);
}

bool triangles_cross(const Triangle& first, const Triangle& second) {
  return any_side_pierces(first, second) || any_side_pierces(second, first);
}

bool triangles_touch(const Triangle& first, const Triangle& second, double gap) {
  if (plane_gap(first, second) > gap || plane_gap(second, first) > gap) return false;
  return triangles_cross(first, second) || closest_points(first, second).squared_distance <= gap * gap;
}

bool triangles_touch(const Triangle& first, const Triangle& second, const ClosestPoints& closest,
                     double gap) {
  if (closest.squared_distance <= gap * gap) return true;
  if (plane_gap(first, second) > gap || plane_gap(second, first) > gap) return false;
  return triangles_cross(first, second);
}

}  // namespace palpate
