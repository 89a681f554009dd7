#include "engine/descent/neighbourhood_descent.h"

#include <algorithm>

namespace palpate {
namespace {

void collect_neighbourhood(const Mesh& mesh, Feature feature, std::vector<std::uint32_t>& triangles) {
  triangles.clear();
  const auto append = [&](std::span<const std::uint32_t> more) {
    triangles.insert(triangles.end(), more.begin(), more.end());
  };
  if (feature.kind == FeatureKind::kVertex) return append(mesh.vertex_triangles[feature.index]);
  if (feature.kind == FeatureKind::kEdge) return append(mesh.edge_triangles[feature.index]);
  for (std::uint32_t edge : mesh.triangle_edges[feature.index]) append(mesh.edge_triangles[edge]);
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
}

}  // namespace

bool NeighbourhoodDescent::descend(const DescentPair& pair, DescentPoint& point, DescentWork& work) {
  for (int step = 0; step < kMaxDescentSteps; ++step) {
    collect_neighbourhood(pair.a(), pair.feature_a(point), around_a_);
    collect_neighbourhood(pair.b(), pair.feature_b(point), around_b_);
    DescentPoint closest = point;
    for (std::uint32_t a : around_a_)
      for (std::uint32_t b : around_b_) {
        const DescentPoint next = pair.measure({a, b}, work);
        if (is_closer(next, closest)) closest = next;
      }
    if (closest.triangles == point.triangles) return true;
    point = closest;
    ++work.steps;
  }
  return false;
}

}  // namespace palpate
