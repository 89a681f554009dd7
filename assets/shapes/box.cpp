#include "assets/shapes/box.h"

#include <utility>

#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {
namespace {

// Corner of the lattice of (n+1)³ points that spans the box.
DVec3 lattice_point(const std::array<int, 3>& at, const Divisions& n, const DVec3& size) {
  DVec3 point;
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = size[axis] * (static_cast<double>(at[axis]) / n[axis] - 0.5);
  return point;
}

void add_cell(TriangleSoup& soup, const std::array<DVec3, 4>& corners, bool reversed) {
  const auto base = static_cast<std::uint32_t>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), corners.begin(), corners.end());
  TriangleIndices first{base, base + 1, base + 2};
  TriangleIndices second{base, base + 2, base + 3};
  if (reversed) {
    std::swap(first[1], first[2]);
    std::swap(second[1], second[2]);
  }
  soup.triangles.push_back(first);
  soup.triangles.push_back(second);
}

// The face across `axis` at its low (level 0) or high (level n) end.
void add_face(TriangleSoup& soup, int axis, int level, const Divisions& n, const DVec3& size) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  for (int i = 0; i < n[u]; ++i) {
    for (int j = 0; j < n[v]; ++j) {
      const auto corner = [&](int di, int dj) {
        std::array<int, 3> at{};
        at[axis] = level;
        at[u] = i + di;
        at[v] = j + dj;
        return lattice_point(at, n, size);
      };
      add_cell(soup, {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}, level == 0);
    }
  }
}

}  // namespace

TriangleSoup box(const DVec3& size, const Divisions& divisions) {
  TriangleSoup soup;
  for (int axis = 0; axis < 3; ++axis) {
    add_face(soup, axis, 0, divisions, size);
    add_face(soup, axis, divisions[axis], divisions, size);
  }
  return welded(soup);
}

TriangleSoup plate(int divisions) {
  return box({0.3, 0.3, 0.02}, {divisions, divisions, 1});
}

TriangleSoup flush_boxes() {
  // Powers of two: the touching planes are equal to the last bit, and no corner of one box is a corner of the
  // other.
  TriangleSoup soup = box({0.125, 0.125, 0.0625});
  translate(soup, {-0.0625, 0.0, 0.0});
  TriangleSoup other = box({0.125, 0.09375, 0.0625});
  translate(other, {0.0625, 0.0, 0.0});
  append(soup, other);
  return rounded_to_float32(std::move(soup));
}

}  // namespace palpate::shapes
