#pragma once

#include "engine/device/simulated/simulated_phantom.h"

namespace palpate {

// A sampled floor at height zero that a simulated hand presses on: the classic test of a haptic loop.
struct VirtualWall {
  PhantomSpec spec;  // its actuators are not limited, so that the loop stays linear
  HandImpedance hand;
  double period;     // s
  int delay;         // samples
  double stiffness;  // N/m
};

// The root mean square of the handle's speed, m/s, over the last half second of a press with `force` newtons.
double residual_speed(const VirtualWall& wall, double force);

// The largest stiffness, to two per cent, at which presses of 0.5, 1 and 3 N come to rest.
double largest_stable_stiffness(VirtualWall wall);

// Where a sampled wall stops being passive: K = b / (T/2 + delay), with all the damping there is (Colgate &
// Schenkel 1997; a delay of whole samples adds to the half one of the hold).
double damping_bound(const VirtualWall& wall);

// Up to where friction burns what quantisation makes, K = 2 f / Δ (Abbott & Okamura 2005).
double friction_bound(const VirtualWall& wall);

}  // namespace palpate
