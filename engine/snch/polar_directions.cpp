#include "engine/snch/polar_directions.h"

#include <array>
#include <cmath>

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

class Collector {
 public:
  Collector(const Mesh& mesh, const Creases* creases, std::vector<Vec3>& directions)
      : mesh_(mesh), creases_(creases), directions_(directions) {
    normals_.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) normals_.emplace_back(unit_normal(mesh, t));
  }

  // Appends the directions of one triangle; false if they have no bound.
  bool collect(std::uint32_t triangle) {
    if (mesh_.double_sided[triangle]) return false;
    directions_.push_back(normals_[triangle]);
    for (int k = 0; k < 3; ++k)
      if (!collect_edge(triangle, mesh_.triangle_edges[triangle][k]) ||
          !collect_vertex(triangle, mesh_.triangles[triangle][k]))
        return false;
    return true;
  }

 private:
  bool collect_edge(std::uint32_t triangle, std::uint32_t edge) {
    const auto triangles = mesh_.edge_triangles[edge];
    if (triangles.front() != triangle) return true;
    if (!mesh_.edge_flags[edge].active && !(creases_ && near_side(mesh_, *creases_, edge))) return true;
    return triangles.size() == 2 && collect_normals(triangle, triangles, mesh_.edge_flags[edge].outward);
  }

  // As many neighbours as triangles: every edge at the vertex has exactly two triangles.
  bool collect_vertex(std::uint32_t triangle, std::uint32_t vertex) {
    const auto triangles = mesh_.vertex_triangles[vertex];
    if (triangles.front() != triangle) return true;
    if (creases_ && near_corner(mesh_, *creases_, vertex)) return collect_cone(creases_->cones[vertex]);
    if (!mesh_.vertex_flags[vertex].active) return true;
    return triangles.size() == mesh_.vertex_neighbours[vertex].size() &&
           collect_normals(triangle, triangles, mesh_.vertex_flags[vertex].outward);
  }

  bool collect_cone(const VertexCone& cone) {
    if (!cone.bounds()) return false;
    const DVec3 axis(cone.normal), size = glm::abs(axis);
    const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    DVec3 side(0.0);
    side[least] = 1.0;
    const DVec3 x = glm::normalize(glm::cross(axis, side)), y = glm::cross(axis, x);
    const double sine = std::sqrt(1.0 - double{cone.cosine} * cone.cosine);
    for (const auto& [across, up] : kOctagon)
      directions_.emplace_back(glm::normalize(axis * double{cone.cosine} + (x * across + y * up) * sine));
    return true;
  }

  bool collect_normals(std::uint32_t own, std::span<const std::uint32_t> triangles, bool outward) {
    if (!outward) return false;
    for (std::uint32_t triangle : triangles)
      if (triangle != own) directions_.push_back(normals_[triangle]);
    return true;
  }

  const Mesh& mesh_;
  const Creases* creases_;  // null: no near minima
  std::vector<Vec3>& directions_;
  std::vector<Vec3> normals_;
};

}  // namespace

PolarDirections::PolarDirections(const Mesh& mesh, std::span<const std::uint32_t> order,
                                 const Creases* creases) {
  Collector collector(mesh, creases, directions);
  directions.reserve(4 * order.size());
  begin.reserve(order.size() + 1);
  unbounded.reserve(order.size());
  for (std::uint32_t triangle : order) {
    begin.push_back(static_cast<std::uint32_t>(directions.size()));
    unbounded.push_back(!collector.collect(triangle));
  }
  begin.push_back(static_cast<std::uint32_t>(directions.size()));
}

}  // namespace palpate
