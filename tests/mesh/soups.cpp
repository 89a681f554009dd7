#include "tests/mesh/soups.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace palpate {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// The two triangles of the quadrilateral a, b, c, d.
void add_quad(TriangleSoup& soup, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  soup.triangles.push_back({a, b, c});
  soup.triangles.push_back({a, c, d});
}

}  // namespace

TriangleSoup cube(const DVec3& centre, double half_side) {
  TriangleSoup soup;
  for (int i = 0; i < 8; ++i)
    soup.positions.push_back(centre + half_side * DVec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  add_quad(soup, 0, 2, 3, 1);
  add_quad(soup, 4, 5, 7, 6);
  add_quad(soup, 0, 1, 5, 4);
  add_quad(soup, 2, 6, 7, 3);
  add_quad(soup, 0, 4, 6, 2);
  add_quad(soup, 1, 3, 7, 5);
  return soup;
}

TriangleSoup ball(const DVec3& centre, double radius) {
  constexpr std::uint32_t kRings = 5, kSectors = 8;
  TriangleSoup soup;
  for (std::uint32_t ring = 1; ring <= kRings; ++ring) {
    const double polar = kTurn / 2 * ring / (kRings + 1);
    for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
      const double angle = kTurn * sector / kSectors;
      const DVec3 out(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
      soup.positions.push_back(centre + radius * out);
    }
  }
  const std::uint32_t north = kRings * kSectors, south = north + 1;
  soup.positions.push_back(centre + DVec3(0, 0, radius));
  soup.positions.push_back(centre - DVec3(0, 0, radius));
  for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
    const std::uint32_t next = (sector + 1) % kSectors, last = (kRings - 1) * kSectors;
    soup.triangles.push_back({north, sector, next});
    soup.triangles.push_back({south, last + next, last + sector});
    for (std::uint32_t row = 0; row < last; row += kSectors)
      add_quad(soup, row + sector, row + kSectors + sector, row + kSectors + next, row + next);
  }
  return soup;
}

TriangleSoup torus(double major_radius, double minor_radius) {
  constexpr std::uint32_t kAround = 24, kAcross = 12;
  TriangleSoup soup;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      const double a = kTurn * i / kAround, b = kTurn * j / kAcross;
      const double r = major_radius + minor_radius * std::cos(b);
      soup.positions.emplace_back(r * std::cos(a), r * std::sin(a), minor_radius * std::sin(b));
      const std::uint32_t row = i * kAcross, next_row = (i + 1) % kAround * kAcross, k = (j + 1) % kAcross;
      add_quad(soup, row + j, next_row + j, next_row + k, row + k);
    }
  }
  return soup;
}

TriangleSoup moebius_strip() {
  constexpr std::uint32_t kSteps = 15;
  TriangleSoup soup;
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const double a = kTurn * i / kSteps;
    const DVec3 out(std::cos(a), std::sin(a), 0);
    const DVec3 across = 0.3 * (std::cos(a / 2) * DVec3(0, 0, 1) + std::sin(a / 2) * out);
    soup.positions.push_back(out - across);
    soup.positions.push_back(out + across);
    const bool last = i + 1 == kSteps;
    const std::uint32_t low = last ? 1 : 2 * i + 2, high = last ? 0 : 2 * i + 3;
    add_quad(soup, 2 * i, low, high, 2 * i + 1);
  }
  return soup;
}

TriangleSoup reversed(TriangleSoup soup) {
  for (TriangleIndices& triangle : soup.triangles) std::swap(triangle[0], triangle[1]);
  return soup;
}

TriangleSoup joined(const std::vector<TriangleSoup>& soups) {
  TriangleSoup all;
  for (const TriangleSoup& soup : soups) {
    const auto base = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), soup.positions.begin(), soup.positions.end());
    for (const TriangleIndices& t : soup.triangles)
      all.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  }
  return all;
}

TriangleSoup with_random_windings(TriangleSoup soup, std::mt19937& random) {
  for (TriangleIndices& triangle : soup.triangles)
    if (random() & 1) std::swap(triangle[0], triangle[1]);
  return soup;
}

Cleaned cleaned(const TriangleSoup& soup, const MeshOptions& options) {
  MeshReport report;
  Result<CleanTriangles> surface = clean_triangles(soup, options, report);
  if (!surface) throw std::runtime_error(surface.error().message);
  return {std::move(surface.value()), std::move(report)};
}

double enclosed_volume(const CleanTriangles& surface, std::uint32_t begin, std::uint32_t end) {
  double volume = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (surface.source[t] < begin || surface.source[t] >= end) continue;
    const auto [a, b, c] = corners(surface, t);
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return volume;
}

std::array<DVec3, 3> corners(const CleanTriangles& surface, std::size_t triangle) {
  std::array<DVec3, 3> corners;
  for (int k = 0; k < 3; ++k)
    corners[k] = surface.frame.metres(DVec3(surface.positions[surface.triangles[triangle][k]]));
  return corners;
}

}  // namespace palpate
