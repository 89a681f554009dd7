#include "engine/snch/node_pair.h"

#include <algorithm>
#include <cmath>

namespace palpate {
namespace {

// Bound on the rounding of a float32 sum of lengths, relative to their size.
constexpr float kRounding = 4e-6f;

float squared(float x) {
  return x * x;
}

// The directions that two cones have in common lie in this one.
struct Lens {
  Vec3 axis;
  float cosine;
  float sine;
  bool empty = false;
};

Lens lens_of(const Vec3& axis, float cosine, float sine, const Vec3& other_axis, float other_cosine,
             float other_sine) {
  const bool wide = cosine < 0, other_wide = other_cosine < 0;
  if (wide && other_wide) return {axis, -1.0f, 0.0f};
  if (other_wide) return {axis, cosine, sine};
  if (wide) return {other_axis, other_cosine, other_sine};
  const float between = glm::dot(axis, other_axis);
  const float sum_cosine = cosine * other_cosine - sine * other_sine;
  if (between < sum_cosine - kRounding) return {axis, 1.0f, 0.0f, true};
  // The chord through the two points where the cones' rims meet is foot + height; a rim's centre beyond the
  // foot has its smaller cone wholly within the other.
  const float across = 1.0f - squared(between);
  if (across > 1e-4f) {
    const float along = (cosine - between * other_cosine) / across;
    const float other_along = (other_cosine - between * cosine) / across;
    if (along > 0 && other_along > 0) {
      const Vec3 foot = axis * along + other_axis * other_along;
      const float length = glm::length(foot);
      const float lens_cosine = length - 1e-5f - kRounding / across;
      if (lens_cosine > 0 && lens_cosine < 1 && lens_cosine > std::max(cosine, other_cosine))
        return {foot / length, lens_cosine, std::sqrt(1.0f - squared(lens_cosine))};
    }
  }
  return cosine > other_cosine ? Lens{axis, cosine, sine} : Lens{other_axis, other_cosine, other_sine};
}

// Squared distance from `d` to the segments from the origin of length `cutoff` along all directions of the
// cone.
float squared_distance_to_sector(const Vec3& d, float d_squared, const Lens& cone, float cutoff) {
  const float along = glm::dot(d, cone.axis);
  const float across = std::sqrt(std::max(0.0f, d_squared - squared(along)));
  if (cone.cosine < 0 || along * cone.sine >= across * cone.cosine)
    return squared(std::max(0.0f, std::sqrt(d_squared) - cutoff));
  const float reach = std::clamp(along * cone.cosine + across * cone.sine, 0.0f, cutoff);
  return squared(along - reach * cone.cosine) + squared(across - reach * cone.sine);
}

}  // namespace

// From A's node to B's.
struct NodePairTest::Gap {
  Vec3 in_a;  // centre to centre, A's frame
  Vec3 in_b;  // the same, B's axes
  float squared;
  float radii;       // of both spheres, rounding added
  Vec3 halves_in_a;  // of both boxes, each in A's axes, rounding added
  Vec3 halves_in_b;
};

NodePairTest::NodePairTest(const Placement& placement, double cutoff)
    : placement_(placement),
      rotation_(placement.rotation),
      ratio_(static_cast<float>(placement.ratio)),
      cutoff_(static_cast<float>(cutoff) * (1.0f + kRounding)) {
  for (int column = 0; column < 3; ++column) magnitude_[column] = glm::abs(rotation_[column]) + kRounding;
}

NodePairTest::Gap NodePairTest::gap_between(const Node& a, const Node& b) const {
  Gap gap;
  gap.in_a = Vec3(placement_.point(DVec3(b.centre)) - DVec3(a.centre));
  gap.squared = glm::dot(gap.in_a, gap.in_a);
  gap.radii = (a.radius + ratio_ * b.radius) * (1.0f + kRounding);
  return gap;
}

void NodePairTest::measure_boxes(const Node& a, const Node& b, Gap& gap) const {
  const Vec3 slack(kRounding * (a.radius + ratio_ * b.radius + cutoff_));
  gap.halves_in_a = a.half + magnitude_ * (ratio_ * b.half) + slack;
  gap.in_b = gap.in_a * rotation_;
  gap.halves_in_b = a.half * magnitude_ + ratio_ * b.half + slack;
}

NodePairTest::Verdict NodePairTest::operator()(const Node& a, const Node& b) const {
  Gap gap = gap_between(a, b);
  if (gap.squared * (1.0f - kRounding) > squared(gap.radii + cutoff_)) return {false, false};

  measure_boxes(a, b, gap);
  const Vec3 apart_in_a = glm::max(glm::abs(gap.in_a) - gap.halves_in_a, 0.0f);
  const Vec3 apart_in_b = glm::max(glm::abs(gap.in_b) - gap.halves_in_b, 0.0f);
  const float apart = std::max(glm::dot(apart_in_a, apart_in_a), glm::dot(apart_in_b, apart_in_b));
  if (apart > squared(cutoff_)) return {false, false};

  const bool contact = apart == 0.0f && gap.squared <= squared(gap.radii);
  const bool minimum = !swept_boxes_miss(a, b, gap) && !cones_miss(a, b, gap);
  return {minimum, contact};
}

Certificate NodePairTest::certify(const Node& a, const Node& b, const MotionRate& rate, double reach) const {
  Gap gap = gap_between(a, b);
  const float between = std::sqrt(gap.squared) * (1.0f - kRounding) - gap.radii;
  if (between > cutoff_) return Certificate::within_distance(between - cutoff_);

  measure_boxes(a, b, gap);
  const auto seen_from_b = [reach](float slack) { return std::min(0.5 * slack, reach); };
  const Vec3 apart_in_a = glm::max(glm::abs(gap.in_a) - gap.halves_in_a, 0.0f);
  const Vec3 apart_in_b = glm::max(glm::abs(gap.in_b) - gap.halves_in_b, 0.0f);
  const float from_a = glm::length(apart_in_a), from_b = glm::length(apart_in_b);
  const double far = std::max<double>(from_a - cutoff_, seen_from_b(from_b - cutoff_));
  if (far > 0) return Certificate::within_distance(far);

  const double apart =
      std::max({static_cast<double>(between), static_cast<double>(from_a), seen_from_b(from_b)});
  if (!(apart > 0)) return {};
  return both(Certificate::within_distance(apart), certify_directions(a, b, gap, rate, reach));
}

// No direction of the one cone meets the other's model within the cutoff.
Certificate NodePairTest::certify_directions(const Node& a, const Node& b, const Gap& gap,
                                             const MotionRate& rate, double reach) const {
  constexpr float kUnit = 1.0f / 255.0f;
  float swept_from_a = 0.0f, swept_from_b = 0.0f;
  for (int k = 0; k < 3; ++k) {
    const float a_sweep = kUnit * static_cast<float>(gap.in_a[k] > 0 ? a.sweep_high[k] : a.sweep_low[k]);
    swept_from_a = std::max(swept_from_a, std::abs(gap.in_a[k]) - gap.halves_in_a[k] - cutoff_ * a_sweep);
    const float b_sweep = kUnit * static_cast<float>(gap.in_b[k] < 0 ? b.sweep_high[k] : b.sweep_low[k]);
    swept_from_b = std::max(swept_from_b, std::abs(gap.in_b[k]) - gap.halves_in_b[k] - cutoff_ * b_sweep);
  }
  const Vec3 b_axis = rotation_ * -b.cone_axis;
  const auto clear_of = [&](const Vec3& axis, float cosine, float sine) {
    const float squared_clear =
        squared_distance_to_sector(gap.in_a, gap.squared, {axis, cosine, sine}, cutoff_);
    return std::sqrt(squared_clear) - gap.radii - kRounding * std::sqrt(gap.squared);
  };
  swept_from_a = std::max(swept_from_a, clear_of(a.cone_axis, a.cone_cosine, a.cone_sine));
  swept_from_b = std::max(swept_from_b, clear_of(b_axis, b.cone_cosine, b.cone_sine));
  const Certificate swept =
      Certificate::within_distance(std::max<double>(swept_from_a, std::min(0.5 * swept_from_b, reach)));
  if (a.cone_cosine < 0 || b.cone_cosine < 0) return swept;

  // The arc tangent is exact for narrow cones, whose cosines are not.
  const float between = std::acos(std::clamp(glm::dot(a.cone_axis, b_axis) + kRounding, -1.0f, 1.0f));
  const float cones = std::atan2(a.cone_sine, a.cone_cosine) + std::atan2(b.cone_sine, b.cone_cosine);
  const Certificate turned = Certificate::within_angle(between - cones - kRounding);
  return longer(swept, turned, rate);
}

bool NodePairTest::cones_miss(const Node& a, const Node& b, const Gap& gap) const {
  const Vec3 b_axis = rotation_ * -b.cone_axis;
  const Lens cone = lens_of(a.cone_axis, a.cone_cosine, a.cone_sine, b_axis, b.cone_cosine, b.cone_sine);
  return cone.empty || squared_distance_to_sector(gap.in_a, gap.squared, cone, cutoff_) >
                           squared(gap.radii) + kRounding * gap.squared;
}

bool NodePairTest::swept_boxes_miss(const Node& a, const Node& b, const Gap& gap) const {
  constexpr float kUnit = 1.0f / 255.0f;
  for (int k = 0; k < 3; ++k) {
    const float a_sweep = kUnit * static_cast<float>(gap.in_a[k] > 0 ? a.sweep_high[k] : a.sweep_low[k]);
    if (std::abs(gap.in_a[k]) - gap.halves_in_a[k] > cutoff_ * a_sweep) return true;
    const float b_sweep = kUnit * static_cast<float>(gap.in_b[k] < 0 ? b.sweep_high[k] : b.sweep_low[k]);
    if (std::abs(gap.in_b[k]) - gap.halves_in_b[k] > cutoff_ * b_sweep) return true;
  }
  return false;
}

}  // namespace palpate
