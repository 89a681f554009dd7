#include "engine/mesh/mesh.h"

#include <algorithm>
#include <numeric>

#include "engine/mesh/polar_cone.h"

namespace palpate {
namespace {

// A side of a triangle, seen from the lower of its two vertices.
struct Side {
  std::uint32_t high_vertex;
  std::uint32_t corner;  // 3 · triangle + k

  friend auto operator<=>(const Side&, const Side&) = default;
};

std::vector<std::uint32_t> prefix_sums(std::vector<std::uint32_t> counts) {
  counts.push_back(0);
  std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), 0u);
  return counts;
}

// Lists by key from (key, item) pairs that `visit(emit)` emits twice in the same order.
template <class Visit>
IndexLists gather(std::size_t keys, const Visit& visit) {
  std::vector<std::uint32_t> counts(keys, 0);
  visit([&](std::uint32_t key, std::uint32_t) { ++counts[key]; });
  IndexLists lists{prefix_sums(std::move(counts)), {}};
  lists.items.resize(lists.begin.back());
  std::vector<std::uint32_t> next(lists.begin.begin(), lists.begin.end() - 1);
  visit([&](std::uint32_t key, std::uint32_t item) { lists.items[next[key]++] = item; });
  return lists;
}

std::pair<std::uint32_t, std::uint32_t> ends_of(const TriangleIndices& triangle, int k) {
  return std::minmax(triangle[k], triangle[(k + 1) % 3]);
}

// All sides, grouped by their lower vertex, sorted within a group by higher vertex and triangle.
std::vector<Side> sorted_sides(const Mesh& mesh, std::vector<std::uint32_t>& begin) {
  const std::size_t count = mesh.triangles.size();
  std::vector<std::uint32_t> counts(mesh.positions.size(), 0);
  for (const TriangleIndices& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++counts[ends_of(triangle, k).first];
  begin = prefix_sums(std::move(counts));
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  std::vector<Side> sides(3 * count);
  for (std::uint32_t t = 0; t < count; ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = ends_of(mesh.triangles[t], static_cast<int>(k));
      sides[next[low]++] = {high, 3 * t + k};
    }
  for (std::size_t v = 0; v + 1 < begin.size(); ++v)
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1]);
  return sides;
}

void connect_edges(Mesh& mesh) {
  std::vector<std::uint32_t> begin;
  const std::vector<Side> sides = sorted_sides(mesh, begin);
  mesh.triangle_edges.resize(mesh.triangles.size());
  mesh.edges.reserve(sides.size() / 2);
  mesh.edge_triangles.items.reserve(sides.size());
  for (std::uint32_t low = 0; low + 1 < begin.size(); ++low)
    for (std::uint32_t i = begin[low]; i < begin[low + 1]; ++i) {
      if (i == begin[low] || sides[i].high_vertex != sides[i - 1].high_vertex) {
        mesh.edge_triangles.begin.push_back(static_cast<std::uint32_t>(mesh.edge_triangles.items.size()));
        mesh.edges.push_back({{low, sides[i].high_vertex}});
      }
      const std::uint32_t corner = sides[i].corner;
      mesh.edge_triangles.items.push_back(corner / 3);
      mesh.triangle_edges[corner / 3][corner % 3] = static_cast<std::uint32_t>(mesh.edges.size() - 1);
    }
  mesh.edge_triangles.begin.push_back(static_cast<std::uint32_t>(mesh.edge_triangles.items.size()));
}

void connect_vertices(Mesh& mesh) {
  mesh.vertex_triangles = gather(mesh.positions.size(), [&](const auto& emit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::uint32_t vertex : mesh.triangles[t]) emit(vertex, t);
  });
  mesh.vertex_neighbours = gather(mesh.positions.size(), [&](const auto& emit) {
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
