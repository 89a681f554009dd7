#include "engine/mesh/line_crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/mesh/soups.h"

namespace palpate {
namespace {

struct Part {
  std::vector<Vec3> positions;
  std::vector<TriangleIndices> triangles;
  std::vector<std::uint32_t> all;

  explicit Part(const TriangleSoup& soup)
      : positions(soup.positions.begin(), soup.positions.end()),
        triangles(soup.triangles),
        all(soup.triangles.size()) {
    std::iota(all.begin(), all.end(), 0u);
  }
  std::vector<int> windings(const std::vector<DVec3>& points) const {
    return winding_numbers({positions, triangles, all}, points);
  }
};

// Van Oosterom & Strackee, "The Solid Angle of a Plane Triangle" (1983).
double solid_angle_winding(const Part& part, const DVec3& point) {
  double sum = 0;
  for (const TriangleIndices& t : part.triangles) {
    const DVec3 a = DVec3(part.positions[t[0]]) - point, b = DVec3(part.positions[t[1]]) - point,
                c = DVec3(part.positions[t[2]]) - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    sum += 2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                          la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

std::vector<DVec3> random_points(std::uint32_t seed, double reach, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-reach, reach);
  std::vector<DVec3> points;
  for (int i = 0; i < count; ++i) points.emplace_back(uniform(random), uniform(random), uniform(random));
  return points;
}

void expect_solid_angles(const TriangleSoup& soup, const std::vector<DVec3>& points) {
  const Part part(soup);
  const std::vector<int> windings = part.windings(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(windings[i], std::lround(solid_angle_winding(part, points[i]))) << i;
}

TEST(LineCrossings, AgreeWithSolidAngles) {
  expect_solid_angles(torus(2.0, 0.7), random_points(1, 2.8, 3000));
  expect_solid_angles(reversed(torus(2.0, 0.7)), random_points(2, 2.8, 1000));
}

TEST(LineCrossings, CountOverlappingShells) {
  const TriangleSoup soup = joined({ball(DVec3(0.0), 1.0), ball(DVec3(0.5, 0, 0), 1.0),
                                    reversed(ball(DVec3(0, 0.4, 0), 0.5)), cube(DVec3(0, 0, 0.5), 0.8)});
  expect_solid_angles(soup, random_points(3, 1.6, 3000));
}

// Points on the planes, edges and diagonals of a cube, continued, where a projection has its ties.
TEST(LineCrossings, AreRightWhereEverythingLinesUp) {
  std::vector<DVec3> points;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z)
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) != 2) points.emplace_back(x, y, z);
  expect_solid_angles(cube(DVec3(0.0), 2.0), points);
}

// Corners straight below the point along the line that the crossings are counted on.
TEST(LineCrossings, AreRightThroughVerticesAndEdges) {
  const TriangleSoup soup = ball(DVec3(0.0), 1.0);
  const DVec3 line(-0.2871937, -0.1730519, 1.0);
  std::vector<DVec3> points;
  for (const DVec3& position : soup.positions) {
    points.push_back(DVec3(Vec3(position)) - 0.05 * line);
    points.push_back(DVec3(Vec3(position)) - 5.0 * line);
  }
  expect_solid_angles(soup, points);
}

}  // namespace
}  // namespace palpate
