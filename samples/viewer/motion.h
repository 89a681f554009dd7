#pragma once

#include <string>
#include <vector>

#include "samples/cli/trajectory.h"
#include "samples/viewer/geometry.h"

namespace palpate::viewer {

enum class MotionKind { kHold, kTap, kPress, kSlide, kOrbit };

MotionKind motion_of(const std::string& name);  // throws cli::Failure

// Where a scripted hand works: it begins clear of a surface at `start`, which lies along -into.
struct Workplace {
  Placement start;    // of the tool
  Placement contact;  // where it nearly touches
  Vec3 into;          // towards the surface
  Vec3 along;         // across it
  Vec3 centre;        // of the scene, to go around
  double depth;       // metres that the hand wants to go beyond the contact
  double travel;      // metres across the surface, to each side
};

// Where the hand wants the tool at a time. Continuous, and periodic after the approach.
Placement intended(MotionKind kind, const Workplace& place, double seconds);

// The same as poses that a simulated hand follows, at even times.
std::vector<cli::TimedPose> sampled(MotionKind kind, const Workplace& place, double seconds);

// Between the poses of a list, and at its ends beyond.
Placement at(const std::vector<cli::TimedPose>& poses, double seconds);

}  // namespace palpate::viewer
