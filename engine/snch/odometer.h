#pragma once

#include <algorithm>
#include <cmath>

#include "engine/mesh/placement.h"

namespace palpate {

// What a certificate is good for: the fact it certifies holds while the models have moved no more than this
// since, by an Odometer. Zero: it may end with the next motion.
struct Certificate {
  double distance = 0.0;  // A's normalised frame
  double angle = 0.0;     // radians

  static constexpr double kForever = 1e30;
  static Certificate forever() { return {kForever, kForever}; }
  static Certificate within_distance(double distance) { return {std::max(0.0, distance), kForever}; }
  static Certificate within_angle(double angle) { return {kForever, std::max(0.0, angle)}; }

  bool holds() const { return distance > 0.0 && angle > 0.0; }
};

// Both facts.
inline Certificate both(const Certificate& one, const Certificate& other) {
  return {std::min(one.distance, other.distance), std::min(one.angle, other.angle)};
}

// How fast the models move, to tell which of two certificates will hold longer.
class MotionRate {
 public:
  MotionRate() : MotionRate(1e-6, 1e-6) {}
  MotionRate(double distance, double angle)
      : distance_(distance), angle_(angle), ticks_a_distance_(1.0 / distance), ticks_an_angle_(1.0 / angle) {}

  double distance() const { return distance_; }  // a tick
  double angle() const { return angle_; }
  double lifetime(const Certificate& certificate) const {
    return std::min(certificate.distance * ticks_a_distance_, certificate.angle * ticks_an_angle_);
  }

 private:
  double distance_;
  double angle_;
  double ticks_a_distance_;  // asked for often: a division is spared
  double ticks_an_angle_;
};

// Either fact will do: the certificate that is likely to hold longer.
inline Certificate longer(const Certificate& one, const Certificate& other, const MotionRate& rate) {
  return rate.lifetime(one) >= rate.lifetime(other) ? one : other;
}

// What a slack is certified for that is measured in B's frame, where a point of A moves by no more than
// S (1 + S / reach) while the odometer moves by S: it may turn about B's centre on an arm that grows
// meanwhile. `reach` is the odometer's.
inline double certified_from_b(double slack, double reach) {
  return slack > 0 ? slack / (1.0 + slack / reach) : slack;
}

// Measures how far model B has moved seen from A, so that no point of B has moved farther. Based on the arc
// lengths of the centre's path and of the turn.
class Odometer {
 public:
  // `centre` (B's normalised frame) and `reach` (A's): every point of B, and of A within the cutoff of B, is
  // within `reach` of the centre.
  Odometer(const DVec3& centre, double reach) : centre_(centre), reach_(reach) {}

  void start(const Placement& placement) { remember(placement); }

  // Adds the motion from the last placement to this one.
  void advance(const Placement& placement) {
    const DVec3 moved = placement.point(centre_) - last_centre_;
    double turned_squared = 0.0;  // the squared Frobenius norm is 8 sin²(angle / 2)
    for (int column = 0; column < 3; ++column) {
      const DVec3 change = placement.rotation[column] - last_rotation_[column];
      turned_squared += glm::dot(change, change);
    }
    const double chord = std::sqrt(0.5 * turned_squared);  // 2 sin(angle / 2)
    const double turned = 2.0 * std::asin(std::min(1.0, 0.5 * chord));
    rate_ = MotionRate(glm::length(moved) + chord * reach_ + kRounding, turned + kRounding);
    distance_ += rate_.distance();
    angle_ += rate_.angle();
    remember(placement);
  }

  void reset() { distance_ = angle_ = 0.0; }

  double distance() const { return distance_; }
  double angle() const { return angle_; }
  const MotionRate& rate() const { return rate_; }  // of the last tick

 private:
  static constexpr double kRounding = 1e-15;

  void remember(const Placement& placement) {
    last_centre_ = placement.point(centre_);
    last_rotation_ = placement.rotation;
  }

  DVec3 centre_;
  double reach_;
  DVec3 last_centre_{0.0};
  DMat3 last_rotation_{1.0};
  double distance_ = 0.0;
  double angle_ = 0.0;
  MotionRate rate_;
};

}  // namespace palpate
