#include "engine/snch/polar_directions.h"

#include "engine/mesh/polar_cone.h"

namespace palpate {
namespace {

class Collector {
 public:
  Collector(const Mesh& mesh, std::vector<Vec3>& directions) : mesh_(mesh), directions_(directions) {
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
    if (triangles.front() != triangle || !mesh_.edge_flags[edge].active) return true;
    return triangles.size() == 2 && collect_normals(triangle, triangles, mesh_.edge_flags[edge].outward);
  }

  // As many neighbours as triangles: every edge at the vertex has exactly two triangles.
  bool collect_vertex(std::uint32_t triangle, std::uint32_t vertex) {
    const auto triangles = mesh_.vertex_triangles[vertex];
    if (triangles.front() != triangle || !mesh_.vertex_flags[vertex].active) return true;
    return triangles.size() == mesh_.vertex_neighbours[vertex].size() &&
           collect_normals(triangle, triangles, mesh_.vertex_flags[vertex].outward);
  }

  bool collect_normals(std::uint32_t own, std::span<const std::uint32_t> triangles, bool outward) {
    if (!outward) return false;
    for (std::uint32_t triangle : triangles)
      if (triangle != own) directions_.push_back(normals_[triangle]);
    return true;
  }

  const Mesh& mesh_;
  std::vector<Vec3>& directions_;
  std::vector<Vec3> normals_;
};

}  // namespace

PolarDirections::PolarDirections(const Mesh& mesh, std::span<const std::uint32_t> order) {
  Collector collector(mesh, directions);
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
