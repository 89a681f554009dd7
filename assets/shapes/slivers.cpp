#include "assets/shapes/slivers.h"

#include "assets/shapes/loft.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {

TriangleSoup slivers() {
  constexpr double kHalfWidth = 0x1p-4;
  constexpr int kGaps = 20;
  std::vector<Ring> rings;
  double gap = 0x1p-23;
  double z = -0x1p-4;
  for (int i = 0; i <= kGaps; ++i) {
    const double half = kHalfWidth + (i % 2 == 1 ? 0.25 * gap : 0.0);
    rings.push_back({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
    z += gap;
    gap *= 2.0;
  }
  return rounded_to_float32(capped_loft(rings));
}

}  // namespace palpate::shapes
