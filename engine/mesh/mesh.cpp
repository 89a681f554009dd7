#include "engine/mesh/mesh.h"

#include "engine/mesh/edge_uses.h"
#include "engine/mesh/polar_cone.h"

namespace palpate {
namespace {

std::uint32_t near_vertex(const Mesh& mesh, const EdgeUse& use) {
  return mesh.triangles[use.triangle()][(use.side() + (use.ascending() ? 0 : 1)) % 3];
}

void connect_edges(Mesh& mesh) {
  const EdgeUses uses(mesh.positions.size(), mesh.triangles);
  mesh.triangle_edges.resize(mesh.triangles.size());
  mesh.edges.reserve(3 * mesh.triangles.size() / 2);
  mesh.edge_triangles.items.reserve(3 * mesh.triangles.size());
  mesh.edge_triangles.begin.push_back(0);
  uses.for_each_edge([&mesh](std::span<const EdgeUse> edge_uses) {
    const auto edge = static_cast<std::uint32_t>(mesh.edges.size());
    mesh.edges.push_back({{near_vertex(mesh, edge_uses.front()), edge_uses.front().far_vertex}});
    for (const EdgeUse& use : edge_uses) {
      mesh.edge_triangles.items.push_back(use.triangle());
      mesh.triangle_edges[use.triangle()][use.side()] = edge;
    }
    mesh.edge_triangles.begin.push_back(static_cast<std::uint32_t>(mesh.edge_triangles.items.size()));
  });
}

void connect_vertices(Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  mesh.vertex_triangles = group_items<std::uint32_t>(count, [&](const auto& emit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::uint32_t vertex : mesh.triangles[t]) emit(vertex, t);
  });
  mesh.vertex_neighbours = group_items<std::uint32_t>(count, [&](const auto& emit) {
    for (const Edge& edge : mesh.edges) {
      emit(edge.vertex[0], edge.vertex[1]);
      emit(edge.vertex[1], edge.vertex[0]);
    }
  });
}

template <class T>
std::size_t bytes_of(const std::vector<T>& items) {
  return items.size() * sizeof(T);
}

std::size_t bytes_of(const std::vector<bool>& items) {
  return items.size() / 8;
}

std::size_t bytes_of(const IndexLists& lists) {
  return bytes_of(lists.begin) + bytes_of(lists.items);
}

}  // namespace

std::size_t Mesh::bytes() const {
  return sizeof(Mesh) + bytes_of(positions) + bytes_of(triangles) + bytes_of(triangle_edges) +
         bytes_of(edges) + bytes_of(edge_triangles) + bytes_of(vertex_triangles) +
         bytes_of(vertex_neighbours) + bytes_of(double_sided) + bytes_of(source) + bytes_of(edge_flags) +
         bytes_of(vertex_flags);
}

std::span<const std::uint32_t> triangles_at(const Mesh& mesh, const Feature& feature) {
  switch (feature.kind) {
    case FeatureKind::kEdge:
      return mesh.edge_triangles[feature.index];
    case FeatureKind::kVertex:
      return mesh.vertex_triangles[feature.index];
    case FeatureKind::kFace:
      break;
  }
  return {&feature.index, 1};
}

Result<Mesh> build_mesh(const TriangleSoup& soup, const MeshOptions& options) {
  Mesh mesh;
  Result<CleanTriangles> clean = clean_triangles(soup, options, mesh.report);
  if (!clean) return clean.error();
  mesh.frame = clean.value().frame;
  mesh.positions = std::move(clean.value().positions);
  mesh.triangles = std::move(clean.value().triangles);
  mesh.double_sided = std::move(clean.value().double_sided);
  mesh.source = std::move(clean.value().source);
  connect_edges(mesh);
  connect_vertices(mesh);
  flag_features(mesh);
  return mesh;
}

}  // namespace palpate
