#include "assets/shapes/saddle.h"

#include <utility>

#include "assets/shapes/box.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {

TriangleSoup saddle(int divisions) {
  constexpr double kCurvature = 4.0;  // [1/m]
  TriangleSoup soup = box({0.2, 0.2, 0.03}, {divisions, divisions, 1});
  for (DVec3& p : soup.positions) p.z += kCurvature * (p.x * p.x - p.y * p.y);
  return rounded_to_float32(std::move(soup));
}

}  // namespace palpate::shapes
