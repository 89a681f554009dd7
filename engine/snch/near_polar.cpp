#include "engine/snch/near_polar.h"

#include <algorithm>
#include <cmath>

#include "engine/mesh/area.h"
#include "engine/mesh/polar_cone.h"

namespace palpate {
namespace {

// A feature is taken out of the search when every direction is farther outside than this.
constexpr double kSurelyOutside = Smoothing::kTangent + 1e-3;

// 1 within a polar cone, fading with the tangent of the lean, whose sine is given.
double within(double sine) {
  if (sine <= 0.0) return 1.0;
  if (sine >= Smoothing::kSine) return 0.0;
  return smooth_step(1.0 - sine / std::sqrt(1.0 - sine * sine) / Smoothing::kTangent);
}

double outward(double along_normal) {
  return smooth_step(1.0 + along_normal / Smoothing::kTangent);
}

// The largest component of `u` along the directions from a vertex into one of its triangles: that of its
// projection where that leads into the triangle, else along a side.
double lean_into(const Mesh& mesh, std::uint32_t triangle, std::uint32_t vertex, const DVec3& u) {
  const TriangleIndices& corners = mesh.triangles[triangle];
  const int k = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
  const DVec3 from = mesh.position(vertex);
  const DVec3 one = mesh.position(corners[(k + 1) % 3]) - from;
  const DVec3 other = mesh.position(corners[(k + 2) % 3]) - from;
  const DVec3 normal = unit_normal(mesh, triangle);
  const DVec3 across = glm::cross(normal, u);
  if (glm::dot(across, one) <= 0.0 && glm::dot(across, other) >= 0.0) return glm::length(across);
  return std::max(glm::dot(one, u) / glm::length(one), glm::dot(other, u) / glm::length(other));
}

// How a vertex's lean does not depend on how its faces are cut.
double lean_into_faces(const Mesh& mesh, std::uint32_t vertex, const DVec3& u) {
  double most = -1.0;
  for (std::uint32_t triangle : mesh.vertex_triangles[vertex])
    most = std::max(most, lean_into(mesh, triangle, vertex, u));
  return most;
}

// The cosine of a cone's angle, and of that and the smoothing angle together.
struct Rim {
  double inner;
  double outer;

  explicit Rim(const VertexCone& cone) : inner(cone.cosine) {
    outer = inner * Smoothing::kCosine - std::sqrt(std::max(0.0, 1.0 - inner * inner)) * Smoothing::kSine;
  }
};

// How far the end of a unit vector must move until its direction has a component above `least`, where it has
// `component` now: the component changes by no more than the end moves, and so does the length.
double way_below(double component, double least) {
  return (least - component) / (1.0 + std::abs(least));
}

// The component of `u` along an edge's pseudonormal; 1 where the outward test does not apply.
double along_edge_normal(const Mesh& mesh, std::uint32_t edge, const DVec3& u) {
  if (!mesh.edge_flags[edge].outward) return 1.0;
  const DVec3 normal = edge_pseudonormal(mesh, edge);
  const double length = glm::length(normal);
  return length > 1e-9 ? glm::dot(normal, u) / length : 1.0;
}

double along_vertex_normal(const Mesh& mesh, const VertexCone& cone, std::uint32_t vertex, const DVec3& u) {
  if (!mesh.vertex_flags[vertex].outward || cone.normal == Vec3(0.0f)) return 1.0;
  return glm::dot(DVec3(cone.normal), u);
}

}  // namespace

double NearPolar::weight(const Feature& feature, const DVec3& u) const {
  if (feature.kind == FeatureKind::kFace) return 1.0;
  const DVec3 own = side_.own(u);
  return feature.kind == FeatureKind::kEdge ? edge_weight(feature.index, own)
                                            : vertex_weight(feature.index, own);
}

double NearPolar::edge_weight(std::uint32_t edge, const DVec3& own) const {
  const double weight = within(edge_violation(side_.mesh, edge, own));
  return weight > 0.0 ? weight * outward(along_edge_normal(side_.mesh, edge, own)) : 0.0;
}

// The cone in place of the outward test, where there is one: beyond it no node's cone reaches.
double NearPolar::vertex_weight(std::uint32_t vertex, const DVec3& own) const {
  const Mesh& mesh = side_.mesh;
  if (vertex_violation(mesh, vertex, own) >= Smoothing::kSine) return 0.0;
  const VertexCone& cone = creases_.cones[vertex];
  const double along = along_vertex_normal(mesh, cone, vertex, own);
  double weight = outward(along);
  if (cone.bounds()) {
    const Rim rim(cone);
    weight = smooth_step((along - rim.outer) / (rim.inner - rim.outer));
  }
  return weight > 0.0 ? weight * within(lean_into_faces(mesh, vertex, own)) : 0.0;
}

double NearPolar::beyond(const Feature& feature, const DVec3& u) const {
  if (feature.kind == FeatureKind::kFace) return 0.0;
  const DVec3 own = side_.own(u);
  const Mesh& mesh = side_.mesh;
  if (feature.kind == FeatureKind::kEdge)
    return std::max(way_below(-edge_violation(mesh, feature.index, own), -Smoothing::kSine),
                    way_below(along_edge_normal(mesh, feature.index, own), -Smoothing::kTangent));
  const VertexCone& cone = creases_.cones[feature.index];
  return std::max(way_below(-vertex_violation(mesh, feature.index, own), -Smoothing::kSine),
                  way_below(along_vertex_normal(mesh, cone, feature.index, own),
                            cone.bounds() ? Rim(cone).outer : -Smoothing::kTangent));
}

bool near_side(const Mesh& mesh, const Creases& creases, std::uint32_t edge) {
  if (creases.is_flat(edge)) return false;
  if (!mesh.edge_flags[edge].outward || mesh.edge_triangles[edge].size() != 2) return true;
  const DVec3 normal = edge_pseudonormal(mesh, edge);
  const double length = glm::length(normal);
  return !(length > 1e-9) || edge_violation(mesh, edge, normal / length) < kSurelyOutside;
}

bool near_corner(const Mesh& mesh, const Creases& creases, std::uint32_t vertex) {
  return creases.is_corner(vertex) && vertex_may_hold(mesh, vertex, kSurelyOutside);
}

}  // namespace palpate
