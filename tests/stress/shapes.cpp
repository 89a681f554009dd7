#include "tests/stress/shapes.h"

#include <cmath>
#include <numbers>

namespace palpate::stress {

TriangleSoup prism(double length, double half_width, double height) {
  const double x = 0.5 * length, y = half_width, z = -height;
  return {{{-x, 0, 0}, {-x, y, z}, {-x, -y, z}, {x, 0, 0}, {x, y, z}, {x, -y, z}},
          {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {0, 2, 5}, {0, 5, 3}, {1, 4, 5}, {1, 5, 2}},
          {}};
}

TriangleSoup fin(double height, double width) {
  return {{{0, 0, 0}, {1, 0, 0}, {0.5, width, 0}, {0.5, 0.5 * width, height}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
          {}};
}

TriangleSoup needle(double length, double width) {
  return {{{0, 0, 0}, {0, width, 0}, {0, 0.5 * width, width}, {length, 0.3 * width, 0.4 * width}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
          {}};
}

TriangleSoup sliver_row(double width, int strips) {
  TriangleSoup soup;
  for (int i = 0; i <= strips; ++i) {
    // A shallow zigzag, so that the sides between strips are ridges and valleys.
    const double x = width * i, z = i % 2 ? 0.2 * width : 0.0;
    soup.positions.insert(soup.positions.end(), {{x, 0, z}, {x, 1, z}, {x, 1, -0.5}, {x, 0, -0.5}});
  }
  const auto quad = [&soup](std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) {
    soup.triangles.push_back({i, j, k});
    soup.triangles.push_back({i, k, l});
  };
  for (int i = 0; i < strips; ++i)
    for (std::uint32_t side = 0; side < 4; ++side) {
      const auto here = static_cast<std::uint32_t>(4 * i), next = here + 4;
      quad(here + side, next + side, next + (side + 1) % 4, here + (side + 1) % 4);
    }
  const auto last = static_cast<std::uint32_t>(4 * strips);
  quad(0, 1, 2, 3);
  quad(last, last + 3, last + 2, last + 1);
  return soup;
}

TriangleSoup spike(int valence, double height) {
  TriangleSoup soup;
  const auto count = static_cast<std::uint32_t>(valence);
  soup.positions = {{0, 0, height}, {0, 0, -0.5}};
  for (int i = 0; i < valence; ++i) {
    const double angle = 2 * std::numbers::pi * i / valence;
    soup.positions.push_back({std::cos(angle), std::sin(angle), 0});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t here = 2 + i, next = 2 + (i + 1) % count;
    soup.triangles.push_back({0, here, next});
    soup.triangles.push_back({1, next, here});
  }
  return soup;
}

TriangleSoup strip_of_triangles(int count, Random& random) {
  TriangleSoup soup;
  const auto corner = [&random] {
    return DVec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  };
  soup.positions = {corner(), corner()};
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    soup.positions.push_back(corner());
    soup.triangles.push_back({i, i + 1, i + 2});
  }
  return soup;
}

void add_zero_area(TriangleSoup& soup, Random& random) {
  for (int i = 0; i < 4; ++i) {
    const TriangleIndices triangle = soup.triangles[random.below(soup.triangles.size())];
    const std::uint32_t from = triangle[0], to = triangle[1];
    if (random.below(2)) {
      soup.triangles.push_back({from, to, from});
      continue;
    }
    soup.positions.push_back(0.5 * (soup.positions[from] + soup.positions[to]));
    soup.triangles.push_back({from, to, static_cast<std::uint32_t>(soup.positions.size() - 1)});
  }
}

void add_duplicates(TriangleSoup& soup, Random& random) {
  for (int i = 0; i < 4; ++i) {
    TriangleIndices triangle = soup.triangles[random.below(soup.triangles.size())];
    if (random.below(2)) triangle = {triangle[1], triangle[2], triangle[0]};
    if (random.below(4) == 0) triangle = {triangle[1], triangle[0], triangle[2]};
    soup.triangles.push_back(triangle);
  }
}

void add_t_junctions(TriangleSoup& soup, Random& random) {
  for (int i = 0; i < 3; ++i) {
    const auto chosen = random.below(soup.triangles.size());
    const TriangleIndices triangle = soup.triangles[chosen];
    const DVec3 &from = soup.positions[triangle[0]], &to = soup.positions[triangle[1]];
    const auto middle = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.push_back(from + random.uniform(0.1, 0.9) * (to - from));
    soup.triangles[chosen] = {triangle[0], middle, triangle[2]};
    soup.triangles.push_back({middle, triangle[1], triangle[2]});
  }
}

void add_noise(TriangleSoup& soup, double size, Random& random) {
  // Corners at one place stay at one place.
  const double seed = random.uniform(1, 2);
  for (DVec3& position : soup.positions) {
    const DVec3 at = position * 64.0;
    const auto noise = [&](double a, double b) {
      const double x = std::sin(seed * (a * at.x + b * at.y + 3.7 * at.z)) * 43758.5453;
      return size * (x - std::floor(x) - 0.5);
    };
    position += DVec3(noise(1.3, 2.1), noise(2.9, 1.7), noise(1.9, 3.1));
  }
}

}  // namespace palpate::stress
