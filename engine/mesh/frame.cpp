#include "engine/mesh/frame.h"

#include <cmath>

namespace palpate {
namespace {

// Zero keeps every input bit where the interval reaches near zero. Elsewhere all numbers of the interval
// share the exponent range of its nearer end, so subtracting a centre on that end's grid is exact in float32
// as well.
double origin_of(double low, double high) {
  const double nearest = low > 0 ? low : high < 0 ? -high : 0.0;
  if (nearest == 0 || nearest < 0.5 * (high - low)) return 0.0;
  const double grid = std::ldexp(1.0, std::ilogb(nearest) - 23);
  if (grid == 0) return 0.0;  // below the range of double
  return std::round(0.5 * (low + high) / grid) * grid;
}

}  // namespace

ModelFrame frame_of(const Box& bounds) {
  ModelFrame frame;
  for (int axis = 0; axis < 3; ++axis) frame.origin[axis] = origin_of(bounds.low[axis], bounds.high[axis]);
  int exponent = 0;
  std::frexp(bounds.diagonal(), &exponent);
  frame.scale = std::ldexp(1.0, exponent);
  return frame;
}

}  // namespace palpate
