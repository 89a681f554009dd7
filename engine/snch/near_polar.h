#pragma once

#include "engine/mesh/creases.h"
#include "engine/snch/tested_triangle.h"

namespace palpate {

// From 0 to 1 without a kink.
inline double smooth_step(double t) {
  if (!(t > 0.0)) return 0.0;
  return t < 1.0 ? t * t * (3.0 - 2.0 * t) : 1.0;
}

// The smoothing angle: how far outside a polar cone a direction is still near it.
struct Smoothing {
  static constexpr double kTangent = 0.05;
  static constexpr double kCosine = 0.99875233887784509;  // 1 / √(1 + tan²)
  static constexpr double kSine = kTangent * kCosine;
};

// How much of a direction the polar cones of one model's features still hold: all within, nothing from the
// smoothing angle outside. Where a direction goes over from one feature to the next, the two shares sum to 1.
// The tangent of the lean fades, because that is what the foot point's way to the end of the higher feature
// is as a part of the distance.
class NearPolar {
 public:
  NearPolar(const MeshSide& side, const Creases& creases) : side_(side), creases_(creases) {}

  const MeshSide& side() const { return side_; }
  const Creases& creases() const { return creases_; }

  // Of a unit direction that leads away, for an edge at right angles to it. Of a face, along whose normal
  // alone closest points are: 1.
  double weight(const Feature& feature, const DVec3& u) const;

  // How far a direction is from any weight, at least: the radians that it must turn and the part of its
  // length that its end must move. Not positive: it may have some.
  double beyond(const Feature& feature, const DVec3& u) const;

 private:
  double edge_weight(std::uint32_t edge, const DVec3& own) const;
  double vertex_weight(std::uint32_t vertex, const DVec3& own) const;

  MeshSide side_;
  const Creases& creases_;
};

// An edge or vertex can hold a near minimum: it is a crease or a corner, and some direction may have weight
// there.
bool near_side(const Mesh& mesh, const Creases& creases, std::uint32_t edge);
bool near_corner(const Mesh& mesh, const Creases& creases, std::uint32_t vertex);

}  // namespace palpate
