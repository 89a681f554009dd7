#include "engine/snch/farthest_point.h"

// Compiled once for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/snch/farthest_point.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace palpate {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, PointList::kPadding>;
using Ints = hn::RebindToSigned<Lanes>;

hn::Vec<Lanes> squared_along(const float* coordinates, float from) {
  const auto way = hn::Sub(hn::LoadU(Lanes(), coordinates), hn::Set(Lanes(), from));
  return hn::Mul(way, way);
}

FarthestPoint farthest(const PointList& points, std::size_t first, std::size_t end, const Vec3& from) {
  const auto none = hn::Set(Lanes(), -1.0f);
  auto most = none;
  auto best = hn::Zero(Ints());
  const auto count = static_cast<std::int32_t>(end - first);
  for (std::int32_t i = 0; i < count; i += static_cast<std::int32_t>(hn::Lanes(Lanes()))) {
    const std::size_t at = first + static_cast<std::size_t>(i);
    const auto x = squared_along(points.coordinates(0) + at, from.x);
    const auto y = squared_along(points.coordinates(1) + at, from.y);
    const auto z = squared_along(points.coordinates(2) + at, from.z);
    const auto lane = hn::Iota(Ints(), i);
    const auto given = hn::RebindMask(Lanes(), hn::Lt(lane, hn::Set(Ints(), count)));
    const auto squared = hn::IfThenElse(given, hn::Add(hn::Add(x, y), z), none);
    const auto farther = hn::Gt(squared, most);
    most = hn::IfThenElse(farther, squared, most);
    best = hn::IfThenElse(hn::RebindMask(Ints(), farther), lane, best);
  }
  const auto greatest = hn::MaxOfLanes(Lanes(), most);
  const auto reached = hn::Eq(most, greatest);
  if (count <= static_cast<std::int32_t>(hn::Lanes(Lanes())))
    return {first + static_cast<std::size_t>(hn::FindFirstTrue(Lanes(), reached)), hn::GetLane(greatest)};
  const auto none_lower = hn::Set(Ints(), count);
  const auto lowest =
      hn::MinOfLanes(Ints(), hn::IfThenElse(hn::RebindMask(Ints(), reached), best, none_lower));
  return {first + static_cast<std::size_t>(hn::GetLane(lowest)), hn::GetLane(greatest)};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace palpate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace palpate {
namespace {

HWY_EXPORT(farthest);

}  // namespace

FarthestPoint farthest_point(const PointList& points, std::size_t first, std::size_t end, const Vec3& from) {
  return HWY_DYNAMIC_DISPATCH(farthest)(points, first, end, from);
}

Cone cone_around(const PointList& directions, std::size_t first, std::size_t end, const DVec3& sum) {
  const int rounds = end - first > 2 ? 4 : 0;  // the middle of two is exact
  constexpr float kRightAngle = 2.0f;
  DVec3 axis = sum, best_axis;
  float best = kRightAngle;
  for (int round = 1; round <= rounds + 1; ++round) {
    const double squared_length = glm::dot(axis, axis);
    if (!(squared_length > 1e-18)) break;
    axis = DVec3(Vec3(axis / std::sqrt(squared_length)));
    const FarthestPoint farthest = farthest_point(directions, first, end, Vec3(axis));
    if (farthest.squared < best) best = farthest.squared, best_axis = axis;
    axis += (DVec3(directions[farthest.index]) - axis) / (round + 1.0);
  }
  return best < kRightAngle ? Cone{best_axis, half_tangent_across(std::sqrt(double{best}))} : Cone::whole();
}

}  // namespace palpate
#endif
