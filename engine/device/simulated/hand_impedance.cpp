#include "engine/device/simulated/hand_impedance.h"

namespace palpate {

// Translation spans what is measured of fingers on a stylus, 100–1,000 N/m and 2–10 N·s/m. Rotation is
// nominal, with a damping ratio near one half.
HandImpedance impedance_of(Grip grip) {
  switch (grip) {
    case Grip::kReleased:
      return {};
    case Grip::kLight:
      return {.mass = 0.05,
              .damping = 2.0,
              .stiffness = 200.0,
              .inertia = 5e-5,
              .angular_damping = 6e-3,
              .angular_stiffness = 0.3};
    case Grip::kFirm:
      return {.mass = 0.15,
              .damping = 10.0,
              .stiffness = 1000.0,
              .inertia = 2e-4,
              .angular_damping = 3e-2,
              .angular_stiffness = 2.0};
  }
  return {};
}

}  // namespace palpate
