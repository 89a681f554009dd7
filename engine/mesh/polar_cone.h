#pragma once

#include "engine/mesh/mesh.h"

namespace palpate {

// The polar cone of a feature holds the directions u with u·d ≤ 0 for every direction d of the tangent cone
// there: the only ones in which a local minimum distance can leave. u is in the normalised frame of the mesh,
// of unit length.

// The largest u·d over unit directions d of the tangent cone at a vertex. Not positive: u is in the polar
// cone.
double vertex_violation(const Mesh& mesh, std::uint32_t vertex, const DVec3& u);

// At least how far every direction between two leans outside the polar cone of a vertex: by one tangent
// direction. The two are of unit length.
double least_vertex_violation(const Mesh& mesh, std::uint32_t vertex, const DVec3& from, const DVec3& to);

// The largest u·d at an edge, for a u at right angles to it.
double edge_violation(const Mesh& mesh, std::uint32_t edge, const DVec3& u);

// How far a direction leans outside a polar cone, and the triangle that holds the direction of the largest
// lean.
struct Lean {
  double amount;  // as the violations
  std::uint32_t triangle;
};

// Of a face, in whose polar cone its normal alone lies, the lean is 0: closest points on a face are along it.
Lean lean_at(const Mesh& mesh, Feature feature, const DVec3& u);

// False: every direction, or every outward one where that test applies, leans more than `lean` outside the
// polar cone of a vertex.
bool vertex_may_hold(const Mesh& mesh, std::uint32_t vertex, double lean);

// Angle-weighted pseudonormals (Bærentzen & Aanæs 2005), not of unit length: u leaves the solid where u·N >
// 0.
DVec3 vertex_pseudonormal(const Mesh& mesh, std::uint32_t vertex);
DVec3 edge_pseudonormal(const Mesh& mesh, std::uint32_t edge);

// u leaves the solid at a vertex or edge. Spares the pseudonormal where u leaves each of the triangles there.
bool leaves_at_vertex(const Mesh& mesh, std::uint32_t vertex, const DVec3& u);
bool leaves_at_edge(const Mesh& mesh, std::uint32_t edge, const DVec3& u);

// The unit normal of a triangle.
DVec3 unit_normal(const Mesh& mesh, std::uint32_t triangle);

// Fills the mesh's edge and vertex flags from its connectivity.
void flag_features(Mesh& mesh);

}  // namespace palpate
