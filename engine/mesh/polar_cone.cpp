#include "engine/mesh/polar_cone.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/mesh/area.h"

namespace palpate {
namespace {

// A feature is taken out of the search only when every direction is at least this far outside its polar cone,
// which is far more than any tolerance or rounding of the search.
constexpr double kSurelyOutside = 1e-4;

// Above this many tangent directions the emptiness of a polar cone is not worth its test.
constexpr std::size_t kMaxTested = 12;

DVec3 direction(const Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  return glm::normalize(mesh.position(to) - mesh.position(from));
}

// The direction in `triangle` at right angles to `edge` that leads away from it.
DVec3 inward(const Mesh& mesh, std::uint32_t edge, std::uint32_t triangle) {
  const auto [from, to] = mesh.edges[edge].vertex;
  const std::uint32_t apex = apex_of(mesh.triangles[triangle], mesh.edges[edge]);
  // In-plane and perpendicular through the normal: stays accurate where the apex is nearly on the edge's
  // line.
  const DVec3 along = mesh.position(to) - mesh.position(from);
  const DVec3 across = glm::cross(glm::cross(along, mesh.position(apex) - mesh.position(from)), along);
  return glm::normalize(across);
}

bool runs_forward(const TriangleIndices& triangle, const Edge& edge) {
  for (int k = 0; k < 3; ++k)
    if (triangle[k] == edge.vertex[0]) return triangle[(k + 1) % 3] == edge.vertex[1];
  return false;
}

// The surface is closed and single-sided around an edge: its triangles pair up, one each way.
bool closed_around(const Mesh& mesh, std::uint32_t edge) {
  int balance = 0;
  for (std::uint32_t triangle : mesh.edge_triangles[edge]) {
    if (mesh.double_sided[triangle]) return false;
    balance += runs_forward(mesh.triangles[triangle], mesh.edges[edge]) ? 1 : -1;
  }
  return balance == 0;
}

bool edge_may_hold(const Mesh& mesh, std::uint32_t edge) {
  const auto triangles = mesh.edge_triangles[edge];
  if (!mesh.edge_flags[edge].outward || triangles.size() != 2) return true;
  return glm::dot(unit_normal(mesh, triangles[0]), inward(mesh, edge, triangles[1])) < kSurelyOutside;
}

// Directions that a u must not lean towards.
struct Tangents {
  std::array<DVec3, kMaxTested> directions;
  std::size_t count = 0;

  double violation(const DVec3& u) const {
    double most = -1.0;
    for (std::size_t i = 0; i < count; ++i) most = std::max(most, glm::dot(directions[i], u));
    return most;
  }
  // One way or the other along a candidate. The lean is positive.
  bool admit(const DVec3& candidate, double lean) const {
    const double most = lean * glm::length(candidate);
    if (!(most > 0)) return false;
    bool forward = true, backward = true;
    for (std::size_t i = 0; i < count && (forward || backward); ++i) {
      const double along = glm::dot(directions[i], candidate);
      forward &= along < most;
      backward &= -along < most;
    }
    return forward || backward;
  }
};

// The u of least violation is normal to a plane through three tips of the unit directions, or, where all lie
// in one plane through the vertex, normal to two of the directions.
bool polar_cone_may_hold(const Tangents& tangents, double lean) {
  const auto& d = tangents.directions;
  for (std::size_t i = 0; i < tangents.count; ++i)
    for (std::size_t j = i + 1; j < tangents.count; ++j) {
      if (tangents.admit(glm::cross(d[i], d[j]), lean)) return true;
      for (std::size_t k = j + 1; k < tangents.count; ++k)
        if (tangents.admit(glm::cross(d[j] - d[i], d[k] - d[i]), lean)) return true;
    }
  return false;
}

// u leaves each of the triangles, beyond rounding: then any mean of their normals has it on its side.
bool leaves_all(const Mesh& mesh, std::span<const std::uint32_t> triangles, const DVec3& u) {
  constexpr double kSurely = 1e-6;
  return std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t triangle) {
    const DVec3 area = area_vector(mesh.positions, mesh.triangles[triangle]);
    const double along = glm::dot(area, u);
    return along > 0 && along * along > kSurely * kSurely * glm::dot(area, area);
  });
}

}  // namespace

bool vertex_may_hold(const Mesh& mesh, std::uint32_t vertex, double lean) {
  const auto neighbours = mesh.vertex_neighbours[vertex];
  if (!mesh.vertex_flags[vertex].outward || neighbours.size() >= kMaxTested) return true;
  Tangents tangents;
  for (std::uint32_t neighbour : neighbours)
    tangents.directions[tangents.count++] = direction(mesh, vertex, neighbour);
  const DVec3 normal = vertex_pseudonormal(mesh, vertex);
  const double length = glm::length(normal);
  if (!(length > kSurelyOutside)) return true;
  if (tangents.violation(normal / length) < lean) return true;
  tangents.directions[tangents.count++] = normal / -length;
  return polar_cone_may_hold(tangents, lean);
}

double vertex_violation(const Mesh& mesh, std::uint32_t vertex, const DVec3& u) {
  const DVec3 from = mesh.position(vertex);
  double most = -1.0;
  for (std::uint32_t neighbour : mesh.vertex_neighbours[vertex]) {
    const DVec3 along = mesh.position(neighbour) - from;
    most = std::max(most, glm::dot(along, u) / glm::length(along));
  }
  return most;
}

double least_vertex_violation(const Mesh& mesh, std::uint32_t vertex, const DVec3& from, const DVec3& to) {
  const DVec3 start = mesh.position(vertex);
  double most = -1.0;
  for (std::uint32_t neighbour : mesh.vertex_neighbours[vertex]) {
    const DVec3 along = mesh.position(neighbour) - start;
    most = std::max(most, std::min(glm::dot(along, from), glm::dot(along, to)) / glm::length(along));
  }
  return most;
}

double edge_violation(const Mesh& mesh, std::uint32_t edge, const DVec3& u) {
  double most = -1.0;
  for (std::uint32_t triangle : mesh.edge_triangles[edge])
    most = std::max(most, glm::dot(inward(mesh, edge, triangle), u));
  return most;
}

Lean lean_at(const Mesh& mesh, Feature feature, const DVec3& u) {
  if (feature.kind == FeatureKind::kFace) return {0.0, feature.index};
  Lean most{-1.0, 0};
  const auto keep_larger = [&most](double amount, std::uint32_t triangle) {
    if (amount > most.amount) most = {amount, triangle};
  };
  if (feature.kind == FeatureKind::kEdge) {
    for (std::uint32_t triangle : mesh.edge_triangles[feature.index])
      keep_larger(glm::dot(inward(mesh, feature.index, triangle), u), triangle);
    return most;
  }
  for (std::uint32_t triangle : mesh.vertex_triangles[feature.index])
    for (std::uint32_t corner : mesh.triangles[triangle])
      if (corner != feature.index) keep_larger(glm::dot(direction(mesh, feature.index, corner), u), triangle);
  return most;
}

DVec3 unit_normal(const Mesh& mesh, std::uint32_t triangle) {
  return glm::normalize(area_vector(mesh.positions, mesh.triangles[triangle]));
}

DVec3 vertex_pseudonormal(const Mesh& mesh, std::uint32_t vertex) {
  DVec3 sum(0.0);
  for (std::uint32_t triangle : mesh.vertex_triangles[vertex]) {
    const TriangleIndices& corners = mesh.triangles[triangle];
    const auto k =
        static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
    const DVec3 one = mesh.position(corners[(k + 1) % 3]) - mesh.position(vertex);
    const DVec3 other = mesh.position(corners[(k + 2) % 3]) - mesh.position(vertex);
    const DVec3 area = glm::cross(one, other);
    const double doubled_area = glm::length(area);
    sum += area * (std::atan2(doubled_area, glm::dot(one, other)) / doubled_area);
  }
  return sum;
}

DVec3 edge_pseudonormal(const Mesh& mesh, std::uint32_t edge) {
  DVec3 sum(0.0);
  for (std::uint32_t triangle : mesh.edge_triangles[edge]) sum += unit_normal(mesh, triangle);
  return sum;
}

bool leaves_at_vertex(const Mesh& mesh, std::uint32_t vertex, const DVec3& u) {
  return leaves_all(mesh, mesh.vertex_triangles[vertex], u) ||
         glm::dot(u, vertex_pseudonormal(mesh, vertex)) > 0;
}

bool leaves_at_edge(const Mesh& mesh, std::uint32_t edge, const DVec3& u) {
  return leaves_all(mesh, mesh.edge_triangles[edge], u) || glm::dot(u, edge_pseudonormal(mesh, edge)) > 0;
}

void flag_features(Mesh& mesh) {
  const auto edge_count = static_cast<std::uint32_t>(mesh.edges.size());
  const auto vertex_count = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.edge_flags.assign(edge_count, {true, true});
  mesh.vertex_flags.assign(vertex_count, {true, true});
  for (std::uint32_t edge = 0; edge < edge_count; ++edge) {
    if (closed_around(mesh, edge)) continue;
    mesh.edge_flags[edge].outward = false;
    for (std::uint32_t vertex : mesh.edges[edge].vertex) mesh.vertex_flags[vertex].outward = false;
  }
  for_each_in_parallel(edge_count,
                       [&](std::uint32_t edge) { mesh.edge_flags[edge].active = edge_may_hold(mesh, edge); });
  for_each_in_parallel(vertex_count, [&](std::uint32_t vertex) {
    mesh.vertex_flags[vertex].active = vertex_may_hold(mesh, vertex, kSurelyOutside);
  });
}

}  // namespace palpate
