#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/clean_triangles.h"
#include "engine/mesh/groups.h"
#include "engine/mesh/mesh_report.h"

namespace palpate {

struct Edge {
  std::uint32_t vertex[2];
};

// The corner of a triangle that is not on one of its edges.
inline std::uint32_t apex_of(const TriangleIndices& triangle, const Edge& edge) {
  for (int k = 0; k < 2; ++k)
    if (triangle[k] != edge.vertex[0] && triangle[k] != edge.vertex[1]) return triangle[k];
  return triangle[2];
}

enum class FeatureKind : std::uint8_t { kFace, kEdge, kVertex };

// A face, edge or vertex of a mesh by its index.
struct Feature {
  FeatureKind kind;
  std::uint32_t index;

  friend bool operator==(const Feature&, const Feature&) = default;
  friend auto operator<=>(const Feature&, const Feature&) = default;
};

// How one feature takes part in the search for local minimum distances.
struct FeatureFlags {
  bool active : 1;   // its polar cone may hold a direction; if not, no LMD ever lies on it
  bool outward : 1;  // the outward test applies: the surface is closed around it and single-sided
};

// A triangle surface with its connectivity. Immutable once built.
struct Mesh {
  ModelFrame frame;
  MeshReport report;

  std::vector<Vec3> positions;                  // normalised frame
  std::vector<TriangleIndices> triangles;       // vertices, counter-clockwise seen from outside
  std::vector<TriangleIndices> triangle_edges;  // edge k joins corners k and (k + 1) % 3
  std::vector<Edge> edges;                      // vertex[0] < vertex[1]
  IndexLists edge_triangles;                    // ascending, so the first one owns the edge
  IndexLists vertex_triangles;                  // ascending, so the first one owns the vertex
  IndexLists vertex_neighbours;                 // the other ends of the edges at a vertex

  std::vector<bool> double_sided;     // by triangle
  std::vector<std::uint32_t> source;  // by triangle: its index in the soup
  std::vector<FeatureFlags> edge_flags;
  std::vector<FeatureFlags> vertex_flags;

  DVec3 position(std::uint32_t vertex) const { return DVec3(positions[vertex]); }
  std::uint32_t owner_of_vertex(std::uint32_t vertex) const { return vertex_triangles[vertex].front(); }
  std::uint32_t owner_of_edge(std::uint32_t edge) const { return edge_triangles[edge].front(); }
  std::size_t bytes() const;  // memory of all arrays
};

// The triangles that hold a feature, ascending. For a face the span is of `feature` itself.
std::span<const std::uint32_t> triangles_at(const Mesh& mesh, const Feature& feature);

// Cleans `soup` and connects it. Errors as clean_triangles.
Result<Mesh> build_mesh(const TriangleSoup& soup, const MeshOptions& options);

}  // namespace palpate
