#include "assets/shapes/l_bracket.h"

#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {

TriangleSoup l_bracket() {
  constexpr double kArm = 0.125;
  constexpr double kThickness = 0.03125;
  constexpr double kHalfDepth = 0.03125;
  constexpr double kOutline[6][2] = {
      {0, 0}, {kArm, 0}, {kArm, kThickness}, {kThickness, kThickness}, {kThickness, kArm}, {0, kArm}};
  TriangleSoup soup;
  for (const double z : {-kHalfDepth, kHalfDepth}) {
    for (const auto& [x, y] : kOutline) soup.positions.emplace_back(x, y, z);
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    soup.triangles.push_back({i, j, j + 6});
    soup.triangles.push_back({i, j + 6, i + 6});
  }
  // The outer corner sees the whole outline, so a fan from it covers the L.
  for (std::uint32_t i = 1; i < 5; ++i) {
    soup.triangles.push_back({0, i + 1, i});
    soup.triangles.push_back({6, i + 6, i + 7});
  }
  translate(soup, {-0.5 * kArm, -0.5 * kArm, 0.0});
  return rounded_to_float32(std::move(soup));
}

}  // namespace palpate::shapes
