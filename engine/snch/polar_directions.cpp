#include "engine/snch/polar_directions.h"

#include <array>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/mesh/polar_cone.h"
#include "engine/snch/near_polar.h"

namespace palpate {
namespace {

// Corners of a regular octagon around a circle of unit radius.
constexpr double kNear = 0.41421356237309503;  // tan 22.5°
constexpr std::array<std::array<double, 2>, 8> kOctagon{{{1.0, kNear},
                                                         {kNear, 1.0},
                                                         {-kNear, 1.0},
                                                         {-1.0, kNear},
                                                         {-1.0, -kNear},
                                                         {-kNear, -1.0},
                                                         {kNear, -1.0},
                                                         {1.0, -kNear}}};

bool add_cone(const VertexCone& cone, PointList& directions) {
  if (!cone.bounds()) return false;
  const DVec3 axis(cone.normal), size = glm::abs(axis);
  const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  DVec3 side(0.0);
  side[least] = 1.0;
  const DVec3 x = glm::normalize(glm::cross(axis, side)), y = glm::cross(axis, x);
  const double sine = std::sqrt(1.0 - double{cone.cosine} * cone.cosine);
  for (const auto& [across, up] : kOctagon)
    directions.push_back(Vec3(glm::normalize(axis * double{cone.cosine} + (x * across + y * up) * sine)));
  return true;
}

}  // namespace

PolarDirections::PolarDirections(const Mesh& mesh, const Creases* creases)
    : mesh_(mesh), creases_(creases), normals_(mesh.triangles.size()) {
  for_each_in_parallel(normals_.size(), [&](std::uint32_t t) { normals_[t] = Vec3(unit_normal(mesh, t)); });
}

bool PolarDirections::add(std::uint32_t triangle, PointList& directions) const {
  if (mesh_.double_sided[triangle]) return false;
  directions.push_back(normals_[triangle]);
  for (int k = 0; k < 3; ++k)
    if (!add_edge(triangle, mesh_.triangle_edges[triangle][k], directions) ||
        !add_vertex(triangle, mesh_.triangles[triangle][k], directions))
      return false;
  return true;
}

bool PolarDirections::add_edge(std::uint32_t triangle, std::uint32_t edge, PointList& directions) const {
  const auto triangles = mesh_.edge_triangles[edge];
  if (triangles.front() != triangle) return true;
  if (!mesh_.edge_flags[edge].active && !(creases_ && near_side(mesh_, *creases_, edge))) return true;
  if (triangles.size() != 2 || !mesh_.edge_flags[edge].outward) return false;
  add_normals(triangle, triangles, directions);
  return true;
}

// As many neighbours as triangles: every edge at the vertex has exactly two triangles.
bool PolarDirections::add_vertex(std::uint32_t triangle, std::uint32_t vertex, PointList& directions) const {
  const auto triangles = mesh_.vertex_triangles[vertex];
  if (triangles.front() != triangle) return true;
  if (creases_ && near_corner(mesh_, *creases_, vertex)) return add_cone(creases_->cones[vertex], directions);
  if (!mesh_.vertex_flags[vertex].active) return true;
  if (triangles.size() != mesh_.vertex_neighbours[vertex].size() || !mesh_.vertex_flags[vertex].outward)
    return false;
  add_normals(triangle, triangles, directions);
  return true;
}

void PolarDirections::add_normals(std::uint32_t own, std::span<const std::uint32_t> triangles,
                                  PointList& directions) const {
  for (std::uint32_t triangle : triangles)
    if (triangle != own) directions.push_back(normals_[triangle]);
}

}  // namespace palpate
