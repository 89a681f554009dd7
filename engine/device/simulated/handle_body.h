#pragma once

#include "engine/device/device_wrench.h"
#include "engine/device/rigid_motion.h"
#include "engine/device/simulated/hand_impedance.h"
#include "engine/math/box.h"

namespace palpate {

// A device's handle as it feels in free motion.
struct HandleProperties {
  double mass = 0.0;              // kg, apparent at the tool
  double damping = 0.0;           // N·s/m
  double friction = 0.0;          // N, Coulomb
  double inertia = 0.0;           // kg·m², the same about every axis
  double angular_damping = 0.0;   // N·m·s/rad
  double angular_friction = 0.0;  // N·m
};

// Joules that went into the handle since it was made.
struct EnergyLedger {
  double by_actuators = 0.0;
  double by_hand = 0.0;  // what the hand did; what it got from the device is the negative
};

// The moving part of a simulated device in a hand: a rigid body of isotropic inertia, balanced against
// gravity, with damping, Coulomb friction and springs at the borders of its workspace.
class HandleBody {
 public:
  HandleBody(const HandleProperties& properties, const Box& workspace)
      : properties_(properties), workspace_(workspace) {}

  // Moves on by `dt` seconds under a constant wrench, while the hand's target moves on at its constant
  // velocity. Semi-implicit in sub-steps of at most 10 µs: spring forces are taken at the old place, damping
  // and friction at the new velocity, so that neither can ever add energy.
  void step(const DeviceWrench& wrench, const HandImpedance& hand, RigidMotion target, double dt);

  const RigidMotion& motion() const { return motion_; }
  const EnergyLedger& energy() const { return energy_; }

  // Places the handle, at rest if the motion says so.
  void place(const RigidMotion& motion) { motion_ = motion; }

 private:
  void step_translation(const DVec3& force, const HandImpedance& hand, const RigidMotion& target, double dt);
  void step_rotation(const DVec3& torque, const HandImpedance& hand, const RigidMotion& target, double dt);
  DVec3 stop_force() const;

  HandleProperties properties_;
  Box workspace_;
  RigidMotion motion_;
  EnergyLedger energy_;
};

}  // namespace palpate
