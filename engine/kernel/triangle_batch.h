#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/kernel/triangle_pair.h"

namespace palpate {

// Measures many pairs of triangles at once, in single precision: their closest points, and a bound of the
// distance that is safe to decide by. As many pairs together as the processor has lanes; every instruction
// set gives the same bits. closest_points() is its twin in double precision.
//
// Based on: V. Lumelsky 1985 (segments), as closest_points(). Ours keeps what single precision has: segments
// take the cross form, feet on a face come from the longest side and the height above it, so that near
// parallels and slivers lose nothing, and of every candidate the distance between its own two points counts,
// never a height above a plane.
class TriangleBatch {
 public:
  static constexpr std::size_t kMost = 16;  // pairs

  // The error of a distance, relative to the largest coordinate of its pair: that of the reduction to single
  // precision included.
  static constexpr float kRounding = 1e-6f;

  template <class T>
  using Row = std::array<T, kMost>;

  // One triangle a column.
  struct Triangles {
    alignas(64) Row<float> corner[3][3];  // [corner][axis]

    // `origin` is shared by the two triangles of a pair, and near both.
    void set(std::size_t column, const Triangle& triangle, const DVec3& origin) {
      for (int k = 0; k < 3; ++k) {
        const DVec3 local = triangle.corner[k] - origin;
        for (int axis = 0; axis < 3; ++axis) corner[k][axis][column] = static_cast<float>(local[axis]);
      }
    }
    void copy(std::size_t column, const Triangles& other, std::size_t from) {
      for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis) corner[k][axis][column] = other.corner[k][axis][from];
    }
  };

  // Relative to the pair's origin.
  struct Closest {
    alignas(64) Row<float> squared_distance;
    alignas(64) Row<float> least_distance;  // the true one is no less, unless the triangles cross
    alignas(64) Row<float> on_first[3];
    alignas(64) Row<float> on_second[3];
    alignas(64) Row<std::int32_t> first_place;  // codes of TrianglePlace
    alignas(64) Row<std::int32_t> second_place;
  };

  Triangles first;
  Triangles second;

  // The first `count` columns; those behind them need not be set, and mean nothing in `closest`.
  void measure(std::size_t count, Closest& closest) const;
};

}  // namespace palpate
