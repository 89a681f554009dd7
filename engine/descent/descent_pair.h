#pragma once

#include <cstdint>

#include "engine/kernel/triangle_pair.h"
#include "engine/mesh/placement.h"
#include "engine/snch/lmd.h"

namespace palpate {

// Work that descents did.
struct DescentWork {
  std::uint64_t descents = 0;
  std::uint64_t steps = 0;           // moves to another pair of triangles or features
  std::uint64_t triangle_pairs = 0;  // measured, or shown not to be closer
};

// Where a descent stands: a pair of triangles and their closest points. A's normalised frame.
struct DescentPoint {
  TrianglePair triangles;
  ClosestPoints closest;
};

// The feature of a mesh that lies at a place of one of its triangles.
Feature feature_at(const Mesh& mesh, std::uint32_t triangle, TrianglePlace place);

// Two meshes at one placement, measured pair by pair.
class DescentPair {
 public:
  DescentPair(const Mesh& a, const Mesh& b, const Placement& placement)
      : a_(a), b_(b), placement_(placement) {}

  const Mesh& a() const { return a_; }
  const Mesh& b() const { return b_; }
  const Placement& placement() const { return placement_; }

  DescentPoint measure(TrianglePair triangles, DescentWork& work) const;
  Feature feature_a(const DescentPoint& point) const;
  Feature feature_b(const DescentPoint& point) const;

 private:
  const Mesh& a_;
  const Mesh& b_;
  const Placement& placement_;
};

// Strictly closer by more than rounding, so that a descent never turns in a circle.
inline bool is_closer(const DescentPoint& next, const DescentPoint& now) {
  constexpr double kDecrease = 1.0 - 8.0 * 2.220446049250313e-16;
  return next.closest.squared_distance < kDecrease * now.closest.squared_distance;
}

// A descent that takes more steps is cut short; the paper's motions need a handful.
inline constexpr int kMaxDescentSteps = 64;

}  // namespace palpate
