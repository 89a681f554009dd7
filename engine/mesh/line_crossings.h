#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/vector.h"
#include "engine/mesh/triangle_soup.h"

namespace palpate {

// A closed, consistently wound part of a surface.
struct ClosedSurface {
  const std::vector<Vec3>& positions;  // normalised frame
  const std::vector<TriangleIndices>& triangles;
  std::span<const std::uint32_t> part;  // the triangles of `triangles` that belong to it
};

// How often `surface` winds around each of `points`, up to a common sign: 0 outside. Points should not lie on
// it.
std::vector<int> winding_numbers(const ClosedSurface& surface, std::span<const DVec3> points);

}  // namespace palpate
