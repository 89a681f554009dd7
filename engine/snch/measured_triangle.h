#pragma once

#include <array>
#include <optional>

#include "engine/snch/polar_arc.h"

namespace palpate {

// A triangle under test and what certificates ask about it, each measured once. A's frame.
class MeasuredTriangle {
 public:
  MeasuredTriangle(const MeshSide& side, const TestedTriangle& tested)
      : side_(side), tested_(tested), normal_(side.normal(tested)) {
    for (int k = 0; k < 3; ++k) {
      const DVec3 along = tested.shape.along(k);
      length_[k] = glm::length(along);
      along_[k] = along / length_[k];
    }
  }

  const MeshSide& side() const { return side_; }
  const TestedTriangle& tested() const { return tested_; }
  const Triangle& shape() const { return tested_.shape; }
  bool two_sided() const { return side_.mesh.double_sided[tested_.index]; }

  const DVec3& normal() const { return normal_; }
  double length(int k) const { return length_[k]; }                   // of a side
  const DVec3& along(int k) const { return along_[k]; }               // a side, of unit length
  DVec3 away(int k) const { return glm::cross(along_[k], normal_); }  // from a side, in the plane

  Feature vertex(int k) const { return side_.vertex(tested_, k); }
  Feature edge(int k) const { return side_.edge(tested_, k); }

  // Of a side that it owns.
  const PolarArc& arc(int k) {
    auto& arc = arcs_[static_cast<std::size_t>(k)];
    if (!arc) arc.emplace(side_, edge(k), along_[k], normal_);
    return *arc;
  }

 private:
  const MeshSide& side_;
  const TestedTriangle& tested_;
  DVec3 normal_;
  double length_[3];
  DVec3 along_[3];
  std::array<std::optional<PolarArc>, 3> arcs_;
};

}  // namespace palpate
