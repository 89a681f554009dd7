#include "assets/shapes/platonic.h"

#include <cmath>

#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {
namespace {

// Three golden rectangles at right angles.
TriangleSoup icosahedron() {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleSoup soup;
  soup.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  soup.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return soup;
}

// Cuts one face. A point of an edge has one zero weight, so both faces of the edge compute the same bits for
// it.
void add_subdivided(TriangleSoup& soup, const DVec3& a, const DVec3& b, const DVec3& c, int frequency,
                    double radius) {
  const auto point = [&](int i, int j) {
    const DVec3 sum = a * double(frequency - i - j) + b * double(i) + c * double(j);
    return sum * (radius / glm::length(sum));
  };
  const auto add = [&](const DVec3& p, const DVec3& q, const DVec3& r) {
    const auto base = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), {p, q, r});
    soup.triangles.push_back({base, base + 1, base + 2});
  };
  for (int i = 0; i < frequency; ++i) {
    for (int j = 0; i + j < frequency; ++j) {
      add(point(i, j), point(i + 1, j), point(i, j + 1));
      if (i + j + 1 < frequency) add(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
    }
  }
}

}  // namespace

TriangleSoup tetrahedron(double radius) {
  const double s = radius / std::sqrt(3.0);
  TriangleSoup soup;
  soup.positions = {{s, s, s}, {-s, -s, s}, {-s, s, -s}, {s, -s, -s}};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return rounded_to_float32(std::move(soup));
}

TriangleSoup icosphere(double radius, int frequency) {
  const TriangleSoup base = icosahedron();
  TriangleSoup soup;
  for (const auto& [a, b, c] : base.triangles) {
    add_subdivided(soup, base.positions[a], base.positions[b], base.positions[c], frequency, radius);
  }
  return welded(soup);
}

TriangleSoup nested_cavities(int frequency) {
  TriangleSoup soup;
  bool cavity = false;
  for (const double radius : {0.1, 0.08, 0.05, 0.03}) {
    TriangleSoup ball = icosphere(radius, frequency);
    if (cavity) turn_inside_out(ball);
    append(soup, ball);
    cavity = !cavity;
  }
  return soup;
}

}  // namespace palpate::shapes
