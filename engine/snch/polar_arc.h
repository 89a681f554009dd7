#pragma once

#include <algorithm>

#include "engine/snch/tested_triangle.h"

namespace palpate {

// The directions, in A's frame, in which a minimum can leave an edge: those between the normals of its two
// triangles. An edge with another number of triangles, or one that minima may leave inward, has no such
// bound.
struct PolarArc {
  bool bounded;
  DVec3 from;
  DVec3 to;

  static PolarArc of(const MeshSide& side, const Feature& edge) {
    const auto triangles = side.mesh.edge_triangles[edge.index];
    if (triangles.size() != 2 || !side.mesh.edge_flags[edge.index].outward) return {false, {}, {}};
    return {true, side.normal(triangles[0]), side.normal(triangles[1])};
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
