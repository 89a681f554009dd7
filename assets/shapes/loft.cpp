#include "assets/shapes/loft.h"

#include <cmath>
#include <numbers>

namespace palpate::shapes {
namespace {

std::uint32_t index(std::size_t value) {
  return static_cast<std::uint32_t>(value);
}

void add_rings(TriangleSoup& soup, const std::vector<Ring>& rings) {
  for (const Ring& ring : rings) soup.positions.insert(soup.positions.end(), ring.begin(), ring.end());
}

// Joins two rings of n points whose vertices start at `lower` and `upper`.
void bridge(TriangleSoup& soup, std::uint32_t lower, std::uint32_t upper, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    soup.triangles.push_back({lower + i, lower + j, upper + j});
    soup.triangles.push_back({lower + i, upper + j, upper + i});
  }
}

void add_cap(TriangleSoup& soup, const Ring& ring, std::uint32_t first, bool at_end) {
  const auto n = index(ring.size());
  const auto hub = index(soup.positions.size());
  DVec3 sum(0.0);
  for (const DVec3& point : ring) sum += point;
  soup.positions.push_back(sum / static_cast<double>(n));
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    if (at_end) {
      soup.triangles.push_back({hub, first + i, first + j});
    } else {
      soup.triangles.push_back({hub, first + j, first + i});
    }
  }
}

double bent(double value, double power) {
  return std::copysign(std::pow(std::abs(value), 2.0 / power), value);
}

}  // namespace

TriangleSoup capped_loft(const std::vector<Ring>& rings) {
  TriangleSoup soup;
  add_rings(soup, rings);
  const auto n = index(rings.front().size());
  const auto last = index(rings.size() - 1);
  for (std::uint32_t r = 0; r < last; ++r) bridge(soup, r * n, (r + 1) * n, n);
  add_cap(soup, rings.front(), 0, false);
  add_cap(soup, rings.back(), last * n, true);
  return soup;
}

TriangleSoup endless_loft(const std::vector<Ring>& rings) {
  TriangleSoup soup;
  add_rings(soup, rings);
  const auto n = index(rings.front().size());
  const auto count = index(rings.size());
  for (std::uint32_t r = 0; r < count; ++r) bridge(soup, r * n, (r + 1) % count * n, n);
  return soup;
}

Ring oval_ring(int points, const DVec3& centre, const DVec3& u, const DVec3& v, double power) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = turn(i, points);
    ring.push_back(centre + u * bent(std::cos(angle), power) + v * bent(std::sin(angle), power));
  }
  return ring;
}

Ring circle_ring(int points, const DVec3& centre, const DVec3& travel, const DVec3& side, double radius) {
  return oval_ring(points, centre, side * radius, glm::cross(travel, side) * radius);
}

double turn(int i, int n) {
  return 2.0 * std::numbers::pi * i / n;
}

}  // namespace palpate::shapes
