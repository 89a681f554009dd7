#pragma once

#include <algorithm>

#include "engine/snch/tested_triangle.h"

namespace palpate {

// The directions, in A's frame, in which a minimum can leave a side that a triangle owns: those between the
// normals of its two triangles. An edge with another number of them, or one that minima may leave inward, has
// no such bound.
struct PolarArc {
  bool bounded;
  DVec3 along;  // the side, of unit length, as it runs around its owner
  DVec3 from;   // the owner's normal
  DVec3 to;

  PolarArc(const MeshSide& side, const Feature& edge, const DVec3& along, const DVec3& normal)
      : bounded(false), along(along), from(normal), to(normal) {
    const auto triangles = side.mesh.edge_triangles[edge.index];
    bounded = triangles.size() == 2 && side.mesh.edge_flags[edge.index].outward;
    if (bounded) to = side.normal(triangles[1]);
  }

  // The largest lean of a direction at right angles to the side outside its polar cone, as edge_violation().
  double violation(const DVec3& u) const {
    const DVec3 across = glm::cross(along, u);
    return std::max(glm::dot(from, across), -glm::dot(to, across));
  }

  // At least how far all of them lean to one side of the plane at right angles to a unit direction; not
  // positive if that cuts the arc.
  double beside(const DVec3& direction) const {
    if (!bounded) return 0.0;
    const double one = glm::dot(from, direction), other = glm::dot(to, direction);
    return std::max(std::min(one, other), -std::max(one, other));
  }

  // At least how far all of them, turned round, lean outside the polar cone of a vertex.
  double beyond(const MeshSide& side, const Feature& vertex) const {
    if (!bounded) return 0.0;
    return least_vertex_violation(side.mesh, vertex.index, side.own(-from), side.own(-to));
  }
};

}  // namespace palpate
