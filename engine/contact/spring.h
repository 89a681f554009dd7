#pragma once

#include "engine/math/vector.h"

namespace palpate {

// A force in newtons and a torque in newton-metres about a point that whoever makes it states.
struct Wrench {
  DVec3 force{0.0};
  DVec3 torque{0.0};

  Wrench& operator+=(const Wrench& other) {
    force += other.force;
    torque += other.torque;
    return *this;
  }
};

// One local minimum distance, or one point of a plateau, as a spring sees it.
struct SpringContact {
  DVec3 point;      // on the tool
  DVec3 direction;  // unit vector from the scene to the tool
  double distance;  // metres
  double weight;    // share of its plateau; the weights of one plateau sum to 1
};

// How every spring of a pair pushes.
struct SpringLaw {
  double stiffness;       // N/m
  double cutoff;          // metres: where the spring is at rest
  double damping = 0.0;   // N·s/m, only while closing
  double friction = 0.0;  // Coulomb's coefficient
};

// The force on the tool, k (c − d) w u of [JW04] section 3.5; zero from the cutoff on, so that it never
// pulls. A wall's spring, whose distance is negative while it is pressed in, grows to 2 k c and no more.
DVec3 spring_force(const SpringContact& contact, const SpringLaw& law);

// A force that acts at `point`, as a wrench about `reference`.
Wrench wrench_about(const DVec3& reference, const DVec3& point, const DVec3& force);

}  // namespace palpate
