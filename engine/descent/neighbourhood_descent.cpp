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

// A lean of λ shortens the distance by no more than about λ² of it, far less than a step must.
bool leans(const DVec3& direction, const DVec3& u) {
  constexpr double kUpright = 1e-9;
  return glm::dot(direction, u) > kUpright * glm::length(direction);
}

int position_of(const TriangleIndices& parts, std::uint32_t part) {
  return static_cast<int>(std::find(parts.begin(), parts.end(), part) - parts.begin());
}

// From a point on `feature`, which the triangle holds unless the feature is another face.
bool leads_along(const Mesh& mesh, std::uint32_t triangle, const Triangle& shape, Feature feature,
                 const DVec3& u) {
  if (feature.kind == FeatureKind::kFace) return feature.index != triangle;
  if (feature.kind == FeatureKind::kVertex) {
    const int corner = position_of(mesh.triangles[triangle], feature.index);
    return leans(shape.along(corner), u) || leans(-shape.along((corner + 2) % 3), u);
  }
  const int side = position_of(mesh.triangle_edges[triangle], feature.index);
  return leans(glm::cross(shape.area_vector(), shape.along(side)), u);
}

}  // namespace

bool NeighbourhoodDescent::descend(const DescentPair& pair, DescentPoint& point, DescentWork& work) {
  for (int step = 0; step < kMaxDescentSteps; ++step) {
    surround(pair, point);
    const TrianglePair before = point.triangles;
    move_to_closest(pair, point, work);
    if (point.triangles == before) return true;
    ++work.steps;
  }
  return false;
}

void NeighbourhoodDescent::surround(const DescentPair& pair, const DescentPoint& point) {
  const DVec3 u = point.closest.on_second - point.closest.on_first;
  const double distance = glm::length(u);
  const auto collect = [&](const Mesh& mesh, Feature feature, const DVec3& away, const auto& shape_of,
                           Neighbours& around) {
    collect_neighbourhood(mesh, feature, around_);
    around.clear();
    for (std::uint32_t triangle : around_) {
      const Triangle shape = shape_of(triangle);
      around.push_back({triangle, shape, leads_along(mesh, triangle, shape, feature, away)});
    }
  };
  collect(
      pair.a(), pair.feature_a(point), u / distance, [&](auto t) { return triangle_of(pair.a(), t); },
      around_a_);
  collect(
      pair.b(), pair.feature_b(point), -u / distance,
      [&](auto t) { return triangle_of(pair.b(), t, pair.placement()); }, around_b_);
}

void NeighbourhoodDescent::move_to_closest(const DescentPair& pair, DescentPoint& point, DescentWork& work) {
  const DVec3 origin = point.closest.on_first;
  std::size_t count = 0;
  for (const Neighbour& a : around_a_)
    for (const Neighbour& b : around_b_) {
      if (!a.may_lead_nearer && !b.may_lead_nearer) {
        ++work.triangle_pairs;
        continue;
      }
      pairs_[count] = {a.index, b.index};
      batch_.first.set(count, a.shape, origin);
      batch_.second.set(count, b.shape, origin);
      if (++count < TriangleBatch::kMost) continue;
      decide(pair, count, point, work);
      count = 0;
    }
  decide(pair, count, point, work);
}

// Takes the closest of the pairs in the batch, in their order, if it is closer.
void NeighbourhoodDescent::decide(const DescentPair& pair, std::size_t count, DescentPoint& closest,
                                  DescentWork& work) {
  if (count == 0) return;
  batch_.measure(count, measured_);
  for (std::size_t i = 0; i < count; ++i) {
    const double least = measured_.least_distance[i];
    if (least * least >= closest.closest.squared_distance) {
      ++work.triangle_pairs;
      continue;
    }
    const DescentPoint next = pair.measure(pairs_[i], work);
    if (is_closer(next, closest)) closest = next;
  }
}

}  // namespace palpate
