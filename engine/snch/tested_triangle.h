#pragma once

#include "engine/mesh/placement.h"
#include "engine/mesh/polar_cone.h"

namespace palpate {

// A triangle under test, its corners in A's frame, and which of its corners and sides take part (bit k:
// corner or side k). Its face always does.
struct TestedTriangle {
  std::uint32_t index;
  Triangle shape;
  unsigned corners;
  unsigned sides;
  unsigned near_corners = 0;  // the same in the search for near minima
  unsigned near_sides = 0;

  bool has_corner(int k) const { return (corners & (1u << k)) != 0; }
  bool has_side(int k) const { return (sides & (1u << k)) != 0; }
  bool has_near_corner(int k) const { return (near_corners & (1u << k)) != 0; }
  bool has_near_side(int k) const { return (near_sides & (1u << k)) != 0; }
};

// One of the two models under test. Directions come in A's frame.
struct MeshSide {
  const Mesh& mesh;
  const Placement& placement;
  bool is_b;

  Feature face(const TestedTriangle& t) const { return {FeatureKind::kFace, t.index}; }
  Feature edge(const TestedTriangle& t, int side) const {
    return {FeatureKind::kEdge, mesh.triangle_edges[t.index][side]};
  }
  Feature vertex(const TestedTriangle& t, int corner) const {
    return {FeatureKind::kVertex, mesh.triangles[t.index][corner]};
  }

  // Outward and of unit length, from the frame of the mesh itself: of a sliver of B, corners that were
  // rounded in A's frame have none that could be trusted, or none at all.
  DVec3 normal(const TestedTriangle& t) const { return normal(t.index); }
  DVec3 normal(std::uint32_t triangle) const {
    const DVec3 own_normal = unit_normal(mesh, triangle);
    return is_b ? placement.rotation * own_normal : own_normal;
  }

  // The largest lean of `u`, which leads away, outside the polar cone of an edge or vertex.
  double violation(const Feature& feature, const DVec3& u) const {
    return feature.kind == FeatureKind::kVertex ? vertex_violation(mesh, feature.index, own(u))
                                                : edge_violation(mesh, feature.index, own(u));
  }

  // `u` leaves the solid at an edge or vertex, or the outward test does not apply there. Of a face the caller
  // knows.
  bool outward(const Feature& feature, const DVec3& u) const {
    if (feature.kind == FeatureKind::kFace) return true;
    const bool is_vertex = feature.kind == FeatureKind::kVertex;
    const FeatureFlags flags = is_vertex ? mesh.vertex_flags[feature.index] : mesh.edge_flags[feature.index];
    if (!flags.outward) return true;
    return is_vertex ? leaves_at_vertex(mesh, feature.index, own(u))
                     : leaves_at_edge(mesh, feature.index, own(u));
  }

  // A direction in the frame of the mesh itself.
  DVec3 own(const DVec3& u) const { return is_b ? placement.into_b(u) : u; }
};

}  // namespace palpate
