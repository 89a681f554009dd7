#include "samples/viewer/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samples/cli/failure.h"

namespace palpate::viewer {
namespace {

constexpr double kApproach = 1.0;   // s
constexpr double kInterval = 0.01;  // s between the poses of a list
constexpr double kTurn = 2.0 * std::numbers::pi;

// From 0 to 1 with both ends at rest.
double eased(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

// From 0 to 1 and back in each period.
double swing(double seconds, double period) {
  return 0.5 - 0.5 * std::cos(kTurn * seconds / period);
}

Placement shifted(const Placement& from, const Vec3& by) {
  return {from.position + by, from.orientation};
}

// The pressed tool, turned about an axis through its own origin.
Placement twisted(const Placement& from, const Vec3& axis, double angle) {
  return {from.position, glm::angleAxis(angle, axis) * from.orientation};
}

Placement tap(const Workplace& place, double seconds) {
  constexpr double kPeriod = 0.8;
  const double share = swing(seconds, kPeriod);
  const Vec3 reach = place.contact.position - place.start.position + place.depth * place.into;
  return shifted(place.start, share * reach);
}

Placement press(const Workplace& place, double seconds) {
  constexpr double kPeriod = 3.0;
  constexpr double kTwist = 0.12;  // rad to each side
  return twisted(place.contact, place.into, kTwist * std::sin(kTurn * seconds / kPeriod));
}

Placement slide(const Workplace& place, double seconds) {
  constexpr double kPeriod = 4.0;
  constexpr double kRoll = 0.5;  // rad to each side
  const double share = std::sin(kTurn * seconds / kPeriod);
  const Vec3 axis = glm::cross(place.into, place.along);
  return twisted(shifted(place.contact, share * place.travel * place.along), axis, kRoll * share);
}

Placement orbit(const Workplace& place, double seconds) {
  constexpr double kPeriod = 12.0;
  const Quat turn = glm::angleAxis(kTurn * seconds / kPeriod, place.along);
  return {place.centre + turn * (place.contact.position - place.centre), turn * place.contact.orientation};
}

// The motion once the tool is pressed in, from a time of 0 on.
Placement pressed(MotionKind kind, const Workplace& place, double seconds) {
  if (kind == MotionKind::kSlide) return slide(place, seconds);
  if (kind == MotionKind::kOrbit) return orbit(place, seconds);
  return press(place, seconds);
}

}  // namespace

MotionKind motion_of(const std::string& name) {
  if (name == "hold") return MotionKind::kHold;
  if (name == "tap") return MotionKind::kTap;
  if (name == "press") return MotionKind::kPress;
  if (name == "slide") return MotionKind::kSlide;
  if (name == "orbit") return MotionKind::kOrbit;
  throw cli::Failure("--motion " + name + ": it is hold, tap, press, slide or orbit");
}

Placement intended(MotionKind kind, const Workplace& place, double seconds) {
  if (kind == MotionKind::kHold) return place.start;
  if (kind == MotionKind::kTap) return tap(place, seconds);
  Workplace deeper = place;
  deeper.contact.position += place.depth * place.into;
  const Vec3 reach = deeper.contact.position - place.start.position;
  if (seconds < kApproach) return shifted(place.start, eased(seconds / kApproach) * reach);
  return pressed(kind, deeper, seconds - kApproach);
}

std::vector<cli::TimedPose> sampled(MotionKind kind, const Workplace& place, double seconds) {
  std::vector<cli::TimedPose> poses;
  const auto count = static_cast<std::size_t>(std::ceil(seconds / kInterval)) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double time = kInterval * static_cast<double>(i);
    poses.push_back({time, pose_of(intended(kind, place, time))});
  }
  return poses;
}

Placement at(const std::vector<cli::TimedPose>& poses, double seconds) {
  const auto after = std::upper_bound(poses.begin(), poses.end(), seconds,
                                      [](double t, const cli::TimedPose& pose) { return t < pose.seconds; });
  if (after == poses.begin()) return placement_of(poses.front().pose);
  if (after == poses.end()) return placement_of(poses.back().pose);
  const auto before = after - 1;
  const double share = (seconds - before->seconds) / (after->seconds - before->seconds);
  const Placement a = placement_of(before->pose), b = placement_of(after->pose);
  return {glm::mix(a.position, b.position, share), glm::slerp(a.orientation, b.orientation, share)};
}

}  // namespace palpate::viewer
