#pragma once

#include <array>

namespace palpate::hid_device {

using Vector = std::array<double, 3>;

// Metres, seconds, radians; +x right, +y up, +z towards the user.
struct Motion {
  Vector position{};
  std::array<double, 4> orientation{0.0, 0.0, 0.0, 1.0};  // x y z w
  Vector velocity{};
  Vector turn_rate{};
};

// A ball on springs: 100 g that a soft hand holds where it wants it, and that motors push and turn.
class Mass {
 public:
  // Where the hand wants it from now on.
  void hold_at(const Vector& place) { wanted_ = place; }

  void step(const Vector& force, const Vector& torque, double dt);

  const Motion& motion() const { return motion_; }

 private:
  Vector wanted_{};
  Motion motion_;
};

}  // namespace palpate::hid_device
