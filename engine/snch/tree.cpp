#include "engine/snch/tree.h"

#include "engine/base/clock.h"
#include "engine/base/parallel.h"
#include "engine/snch/near_polar.h"
#include "engine/snch/node_filler.h"

namespace palpate {
namespace {

std::vector<OwnedFeatures> owned_features(const Mesh& mesh) {
  std::vector<OwnedFeatures> owned(mesh.triangles.size());
  for_each_in_parallel(owned.size(), [&](std::uint32_t t) {
    unsigned corners = 0, sides = 0;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[t][k], edge = mesh.triangle_edges[t][k];
      if (mesh.owner_of_vertex(vertex) == t && mesh.vertex_flags[vertex].active) corners |= 1u << k;
      if (mesh.owner_of_edge(edge) == t && mesh.edge_flags[edge].active) sides |= 1u << k;
    }
    owned[t] = {static_cast<std::uint8_t>(corners & 7u), static_cast<std::uint8_t>(sides & 7u), 0, 0};
  });
  return owned;
}

void add_near_features(const Mesh& mesh, const Creases& creases, std::vector<OwnedFeatures>& owned) {
  for_each_in_parallel(owned.size(), [&](std::uint32_t t) {
    unsigned corners = 0, sides = 0;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[t][k], edge = mesh.triangle_edges[t][k];
      if (mesh.owner_of_vertex(vertex) == t && near_corner(mesh, creases, vertex)) corners |= 1u << k;
      if (mesh.owner_of_edge(edge) == t && near_side(mesh, creases, edge)) sides |= 1u << k;
    }
    owned[t].near_corners = static_cast<std::uint8_t>(corners & 7u);
    owned[t].near_sides = static_cast<std::uint8_t>(sides & 7u);
  });
}

}  // namespace

Tree Tree::build(const Mesh& mesh) {
  return build(mesh, nullptr);
}

Tree Tree::build(const Mesh& mesh, const Creases& creases) {
  return build(mesh, &creases);
}

Tree Tree::build(const Mesh& mesh, const Creases* creases) {
  const Stopwatch watch;
  Tree tree;
  NodeFiller(mesh, creases, tree.nodes_).fill(Topology(mesh));
  tree.owned_ = owned_features(mesh);
  if (creases) add_near_features(mesh, *creases, tree.owned_);
  tree.build_us_ = watch.elapsed_us();
  return tree;
}

}  // namespace palpate
