#pragma once

#include <cmath>
#include <vector>

#include "assets/shapes/organic.h"
#include "tests/bench/effort.h"
#include "tests/support/models.h"

namespace palpate::bench {

// About so many triangles of one shape.
inline TriangleSoup sized_shape(double triangles) {
  const double per_side = std::sqrt(triangles / 97000.0);
  shapes::Divisions divisions = shapes::kOrganicFine;
  for (auto& cells : divisions) cells = static_cast<int>(std::lround(per_side * cells));
  return shapes::organic(divisions);
}

// The numbers of triangles that a bench goes through.
inline std::vector<double> sizes_from(double least, const Effort& effort) {
  std::vector<double> sizes;
  const double most = effort.quick ? 100e3 : effort.largest ? 10e6 : 1e6;
  for (double size = least; size <= most; size *= 10) sizes.push_back(size);
  return sizes;
}

}  // namespace palpate::bench
