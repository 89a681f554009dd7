#pragma once

#include <random>

#include "engine/mesh/clean_triangles.h"

namespace palpate {

// Closed shapes that face outward.
TriangleSoup cube(const DVec3& centre, double half_side);
TriangleSoup ball(const DVec3& centre, double radius);
TriangleSoup torus(double major_radius, double minor_radius);  // about the z axis

// A strip of equal triangles around the z axis, closed with a half twist.
TriangleSoup moebius_strip();

TriangleSoup reversed(TriangleSoup soup);
TriangleSoup joined(const std::vector<TriangleSoup>& soups);
TriangleSoup with_random_windings(TriangleSoup soup, std::mt19937& random);

struct Cleaned {
  CleanTriangles surface;
  MeshReport report;
};

// Throws std::runtime_error with the reason if the soup cannot be cleaned.
Cleaned cleaned(const TriangleSoup& soup, const MeshOptions& options = {});

// What the triangles that came from soup triangles [begin, end) enclose, in cubic metres; negative if inward.
double enclosed_volume(const CleanTriangles& surface, std::uint32_t begin, std::uint32_t end);

// The corners of a triangle in metres.
std::array<DVec3, 3> corners(const CleanTriangles& surface, std::size_t triangle);

}  // namespace palpate
