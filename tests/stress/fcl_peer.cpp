#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>

#include "tests/stress/peers.h"

namespace palpate::stress {
namespace {

template <class S>
double distance_in(const Triangle& a, const Triangle& b) {
  fcl::Vector3<S> corners_a[3], corners_b[3], on_a, on_b;
  for (int k = 0; k < 3; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      corners_a[k][axis] = static_cast<S>(a.corner[k][axis]);
      corners_b[k][axis] = static_cast<S>(b.corner[k][axis]);
    }
  return fcl::detail::TriangleDistance<S>::triDistance(corners_a, corners_b, on_a, on_b);
}

}  // namespace

double fcl_distance(const Triangle& a, const Triangle& b) {
  return distance_in<double>(a, b);
}

double fcl_distance_in_single(const Triangle& a, const Triangle& b) {
  return distance_in<float>(a, b);
}

}  // namespace palpate::stress
