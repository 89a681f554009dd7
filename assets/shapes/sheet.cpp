#include "assets/shapes/sheet.h"

#include <cmath>

#include "assets/shapes/loft.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {
namespace {

// Two triangles to each cell of rows × columns vertices; `next_row` is the row that follows and `mirrored`
// runs it backwards, as behind the seam of a half twist.
void add_row_of_cells(TriangleSoup& soup, std::uint32_t row, std::uint32_t next_row, std::uint32_t columns,
                      bool mirrored) {
  const auto at_next = [&](std::uint32_t j) { return next_row * columns + (mirrored ? columns - 1 - j : j); };
  for (std::uint32_t j = 0; j + 1 < columns; ++j) {
    const std::uint32_t a = row * columns + j;
    soup.triangles.push_back({a, at_next(j), at_next(j + 1)});
    soup.triangles.push_back({a, at_next(j + 1), a + 1});
  }
}

}  // namespace

TriangleSoup open_sheet(int divisions) {
  constexpr double kSize = 0.2;
  constexpr double kWaveHeight = 0.01;
  const auto n = static_cast<std::uint32_t>(divisions);
  TriangleSoup soup;
  for (int i = 0; i <= divisions; ++i) {
    for (int j = 0; j <= divisions; ++j) {
      const double wave = std::sin(turn(i, divisions)) * std::cos(turn(j, divisions));
      const double u = static_cast<double>(i) / divisions - 0.5;
      const double v = static_cast<double>(j) / divisions - 0.5;
      soup.positions.emplace_back(kSize * u, kSize * v, kWaveHeight * wave);
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) add_row_of_cells(soup, i, i + 1, n + 1, false);
  return rounded_to_float32(std::move(soup));
}

TriangleSoup two_sided_sheet(int divisions) {
  TriangleSoup soup = open_sheet(divisions);
  soup.double_sided.assign(soup.triangles.size(), true);
  return soup;
}

TriangleSoup mobius_strip(int around, int across) {
  constexpr double kRadius = 0.1;
  constexpr double kWidth = 0.05;
  TriangleSoup soup;
  for (int i = 0; i < around; ++i) {
    const double angle = turn(i, around);
    const DVec3 outward(std::cos(angle), std::sin(angle), 0.0);
    const DVec3 over = outward * std::cos(0.5 * angle) + DVec3(0.0, 0.0, std::sin(0.5 * angle));
    for (int j = 0; j <= across; ++j) {
      soup.positions.push_back(outward * kRadius + over * (kWidth * (static_cast<double>(j) / across - 0.5)));
    }
  }
  const auto rows = static_cast<std::uint32_t>(around);
  const auto columns = static_cast<std::uint32_t>(across) + 1;
  for (std::uint32_t i = 0; i < rows; ++i) add_row_of_cells(soup, i, (i + 1) % rows, columns, i + 1 == rows);
  soup.double_sided.assign(soup.triangles.size(), true);
  return rounded_to_float32(std::move(soup));
}

}  // namespace palpate::shapes
