#pragma once

#include <algorithm>

#include "engine/snch/odometer.h"

namespace palpate {

// The readings of an odometer up to which a certificate holds. Float32, rounded to the safe side.
struct Until {
  float distance;
  float angle;

  static constexpr Until passed() { return {-1.0f, -1.0f}; }
  static constexpr Until never() { return {1e30f, 1e30f}; }

  bool has_passed(const Until& now) const { return !(now.distance < distance && now.angle < angle); }
};

inline Until earlier(const Until& one, const Until& other) {
  return {std::min(one.distance, other.distance), std::min(one.angle, other.angle)};
}

// An odometer as certificates read it.
class Readings {
 public:
  explicit Readings(const Odometer& odometer) : distance_(odometer.distance()), angle_(odometer.angle()) {}

  Until now() const { return {rounded_up(distance_), rounded_up(angle_)}; }

  Until until(const Certificate& certificate) const {
    if (!certificate.holds()) return Until::passed();
    return {rounded_down(distance_ + kKept * certificate.distance),
            rounded_down(angle_ + kKept * certificate.angle)};
  }

  // The same when the odometer is set back to 0.
  Until set_back(const Until& until) const {
    return {rounded_down(until.distance - distance_), rounded_down(until.angle - angle_)};
  }

 private:
  // Certificates lose this part, which covers the rounding of the odometer and of float32 expiries.
  static constexpr double kKept = 0.999;

  // A float32 below x if that is positive; not positive otherwise.
  static float rounded_down(double x) { return static_cast<float>(x) * (1.0f - 0x1p-23f); }

  // A float32 no less than x, which is not negative.
  static float rounded_up(double x) { return static_cast<float>(x) * (1.0f + 0x1p-22f); }

  double distance_;
  double angle_;
};

}  // namespace palpate
