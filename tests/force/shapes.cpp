#include "tests/force/shapes.h"

#include <algorithm>
#include <map>

#include "engine/math/vector.h"

namespace palpate::shapes {
namespace {

// The middle of each side, made once.
class Middles {
 public:
  explicit Middles(TriangleSoup& soup) : soup_(soup) {}

  std::uint32_t of(std::uint32_t one, std::uint32_t other) {
    const auto [place, is_new] =
        known_.try_emplace(std::minmax(one, other), static_cast<std::uint32_t>(soup_.positions.size()));
    if (is_new) soup_.positions.push_back(0.5 * (soup_.positions[one] + soup_.positions[other]));
    return place->second;
  }

 private:
  TriangleSoup& soup_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known_;
};

void add_quad(TriangleSoup& soup, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  soup.triangles.push_back({a, b, c});
  soup.triangles.push_back({a, c, d});
}

}  // namespace

TriangleSoup ridge(double length, double width, double height, int divisions) {
  TriangleSoup soup;
  for (int i = 0; i <= divisions; ++i) {
    const double x = length * (static_cast<double>(i) / divisions - 0.5);
    soup.positions.insert(soup.positions.end(),
                          {{x, 0, 0}, {x, 0.5 * width, -height}, {x, -0.5 * width, -height}});
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(divisions); ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t here = 3 * i + k, next = 3 * i + (k + 1) % 3;
      add_quad(soup, here, here + 3, next + 3, next);
    }
  const std::uint32_t last = 3 * static_cast<std::uint32_t>(divisions);
  soup.triangles.push_back({0, 1, 2});
  soup.triangles.push_back({last, last + 2, last + 1});
  return soup;
}

TriangleSoup bowl(double radius, double half_width, int divisions) {
  TriangleSoup soup;
  const auto side = static_cast<std::uint32_t>(divisions) + 1;
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i * side + j; };
  const auto coordinate = [&](std::uint32_t i) { return half_width * (2.0 * i / divisions - 1.0); };
  for (std::uint32_t i = 0; i < side; ++i)
    for (std::uint32_t j = 0; j < side; ++j) {
      const double x = coordinate(i), y = coordinate(j);
      soup.positions.emplace_back(x, y, (x * x + y * y) / (2 * radius));
    }
  for (std::uint32_t i = 0; i + 1 < side; ++i)
    for (std::uint32_t j = 0; j + 1 < side; ++j)
      add_quad(soup, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  // The underside is a cone to a point below.
  const auto tip = static_cast<std::uint32_t>(soup.positions.size());
  soup.positions.emplace_back(0, 0, -half_width);
  for (std::uint32_t k = 0; k + 1 < side; ++k) {
    soup.triangles.push_back({at(k + 1, 0), at(k, 0), tip});
    soup.triangles.push_back({at(side - 1, k + 1), at(side - 1, k), tip});
    soup.triangles.push_back({at(k, side - 1), at(k + 1, side - 1), tip});
    soup.triangles.push_back({at(0, k), at(0, k + 1), tip});
  }
  return soup;
}

TriangleSoup stylus(double height, double half_width) {
  TriangleSoup soup;
  const double w = half_width;
  soup.positions = {{0, 0, 0}, {-w, -w, height}, {w, -w, height}, {w, w, height}, {-w, w, height}};
  soup.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {1, 2, 3}, {1, 3, 4}};
  return soup;
}

TriangleSoup refined(const TriangleSoup& soup) {
  TriangleSoup fine;
  fine.positions = soup.positions;
  Middles middles(fine);
  for (const auto& [a, b, c] : soup.triangles) {
    const std::uint32_t ab = middles.of(a, b), bc = middles.of(b, c), ca = middles.of(c, a);
    fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

}  // namespace palpate::shapes
