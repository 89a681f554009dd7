#include "assets/shapes/gear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/shapes/loft.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {
namespace {

constexpr double kTipRadius = 0.06;
constexpr double kHalfWidth = 0.011;
constexpr double kHubHalfWidth = 0.014;
constexpr double kRecess = 0.005;  // depth of the web below the rim
constexpr double kBoreRadius = 0.010;
constexpr double kHubRadius = 0.019;
constexpr double kRootFlare = 0.4;  // part of the gap's half angle that a tooth takes at its root
constexpr double kPressureAngle = 20.0 * std::numbers::pi / 180.0;

struct Polar {
  double radius;
  double angle;
};

double involute(double angle) {
  return std::tan(angle) - angle;
}

// Addendum 1 module, dedendum 1.25 modules. Below the base circle the flank flares out to the root, so that
// angles ascend strictly from point to point and every radius of the gear crosses the outline once.
class ToothProfile {
 public:
  explicit ToothProfile(int teeth)
      : teeth_(teeth),
        module_(2.0 * kTipRadius / (teeth + 2)),
        base_(0.5 * module_ * teeth * std::cos(kPressureAngle)) {}

  double root_radius() const { return module_ * (0.5 * teeth_ - 1.25); }

  // Ten points a tooth, counter-clockwise: the right flank upwards, tip, the left flank downwards, middle of
  // the gap.
  std::vector<Polar> points() const {
    std::vector<Polar> result;
    const double radii[] = {root_radius(), base_, 0.5 * (base_ + kTipRadius), kTipRadius};
    for (int tooth = 0; tooth < teeth_; ++tooth) {
      const double middle = turn(tooth, teeth_);
      for (int i = 0; i < 4; ++i) result.push_back({radii[i], middle - half_angle(radii[i])});
      result.push_back({kTipRadius, middle});
      for (int i = 3; i >= 0; --i) result.push_back({radii[i], middle + half_angle(radii[i])});
      result.push_back({root_radius(), middle + std::numbers::pi / teeth_});
    }
    return result;
  }

 private:
  // Half of the tooth's thickness at a radius, as an angle.
  double half_angle(double radius) const {
    const double at_pitch = 0.5 * std::numbers::pi / teeth_ + involute(kPressureAngle);
    if (radius < base_) return at_pitch + kRootFlare * (std::numbers::pi / teeth_ - at_pitch);
    return at_pitch - involute(std::acos(std::min(1.0, base_ / radius)));
  }

  int teeth_;
  double module_;
  double base_;
};

Ring toothed_ring(const std::vector<Polar>& profile, double z) {
  Ring ring;
  for (const auto& [radius, angle] : profile)
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  return ring;
}

Ring round_ring(const std::vector<Polar>& profile, double radius, double z) {
  Ring ring;
  for (const Polar& point : profile)
    ring.emplace_back(radius * std::cos(point.angle), radius * std::sin(point.angle), z);
  return ring;
}

}  // namespace

TriangleSoup gear(int teeth) {
  const ToothProfile tooth(teeth);
  const std::vector<Polar> profile = tooth.points();
  const double rim = 0.88 * tooth.root_radius();
  const double floor = kHalfWidth - kRecess;
  std::vector<Ring> rings;
  for (const double part : {-1.0, -1.0 / 3, 1.0 / 3, 1.0})
    rings.push_back(toothed_ring(profile, part * kHalfWidth));
  rings.push_back(round_ring(profile, rim, kHalfWidth));
  rings.push_back(round_ring(profile, rim - 0.5 * kRecess, floor));
  rings.push_back(round_ring(profile, kHubRadius + 0.5 * kRecess, floor));
  rings.push_back(round_ring(profile, kHubRadius, kHubHalfWidth));
  for (const double part : {1.0, 0.0, -1.0})
    rings.push_back(round_ring(profile, kBoreRadius, part * kHubHalfWidth));
  rings.push_back(round_ring(profile, kHubRadius, -kHubHalfWidth));
  rings.push_back(round_ring(profile, kHubRadius + 0.5 * kRecess, -floor));
  rings.push_back(round_ring(profile, rim - 0.5 * kRecess, -floor));
  rings.push_back(round_ring(profile, rim, -kHalfWidth));
  return rounded_to_float32(endless_loft(rings));
}

}  // namespace palpate::shapes
