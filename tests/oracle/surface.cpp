#include "tests/oracle/surface.h"

#include <algorithm>
#include <cmath>

namespace palpate::oracle {

Surface::Surface(const Mesh& mesh) : triangles(mesh.triangles), double_sided(mesh.double_sided), mesh_(mesh) {
  DVec3 low(1e300), high(-1e300);
  for (const Vec3& position : mesh.positions) {
    positions.push_back(mesh.frame.metres(DVec3(position)));
    low = glm::min(low, positions.back());
    high = glm::max(high, positions.back());
  }
  diagonal = glm::length(high - low);
  at_vertex_.resize(positions.size());
  open_vertex_.resize(positions.size());
  for (TriangleIndex t = 0; t < triangles.size(); ++t) {
    const auto& c = triangles[t];
    normals.push_back(
        glm::normalize(glm::cross(positions[c[1]] - positions[c[0]], positions[c[2]] - positions[c[0]])));
    sides_.push_back({});
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = c[k], to = c[(k + 1) % 3];
      const auto [at, is_new] =
          edge_between_.try_emplace(std::minmax(from, to), static_cast<std::uint32_t>(edges_.size()));
      if (is_new) {
        edges_.emplace_back();
        edge_ends_.push_back({std::min(from, to), std::max(from, to)});
      }
      edges_[at->second].triangles.push_back(t);
      edges_[at->second].balance += from < to ? 1 : -1;
      sides_[t][k] = at->second;
      at_vertex_[from].push_back(t);
    }
  }
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
    if (skips_outward_test({1, e}))
      for (std::uint32_t v : edge_ends_[e]) open_vertex_[v] = true;
}

Place Surface::place_of(Feature feature) const {
  if (feature.kind == FeatureKind::kFace) return {2, feature.index};
  if (feature.kind == FeatureKind::kVertex) return {0, feature.index};
  const auto [from, to] = mesh_.edges[feature.index].vertex;
  return {1, edge_between_.at({from, to})};
}

Place Surface::lowest_at(Place place, const DVec3& point, double near) const {
  if (place.dimension == 0) return place;
  const TriangleIndex triangle = star(place).front();
  const auto& corners = triangles[triangle];
  for (std::uint32_t corner : corners)
    if (glm::length(positions[corner] - point) <= near) return {0, corner};
  if (place.dimension == 1) return place;
  for (int k = 0; k < 3; ++k) {
    const Place side{1, edge(triangle, k)};
    const DVec3 arm = point - positions[corners[k]];
    if (glm::length(arm - direction(side) * glm::dot(arm, direction(side))) <= near) return side;
  }
  return place;
}

DVec3 Surface::direction(Place edge) const {
  const auto [from, to] = edge_ends_[edge.index];
  return glm::normalize(positions[to] - positions[from]);
}

std::vector<TriangleIndex> Surface::star(Place place) const {
  if (place.dimension == 2) return {place.index};
  return place.dimension == 1 ? edges_[place.index].triangles : at_vertex_[place.index];
}

double Surface::lean(Place place, const DVec3& u) const {
  if (place.dimension == 2)
    return std::sqrt(std::max(0.0, 1.0 - std::pow(glm::dot(u, normals[place.index]), 2)));
  double most = -1.0;
  for (TriangleIndex t : star(place)) {
    const auto& c = triangles[t];
    if (place.dimension == 1) {
      const auto [from, to] = edge_ends_[place.index];
      const DVec3 along = glm::normalize(positions[to] - positions[from]);
      DVec3 into = glm::cross(normals[t], along);
      for (int k = 0; k < 3; ++k)
        if (c[k] != from && c[k] != to && glm::dot(into, positions[c[k]] - positions[from]) < 0) into = -into;
      most = std::max(most, glm::dot(u, into));
    } else {
      for (int k = 0; k < 3; ++k)
        if (c[k] != place.index)
          most = std::max(most, glm::dot(u, glm::normalize(positions[c[k]] - positions[place.index])));
    }
  }
  return most;
}

bool Surface::skips_outward_test(Place place) const {
  const auto on = star(place);
  if (std::any_of(on.begin(), on.end(), [&](TriangleIndex t) { return double_sided[t]; })) return true;
  if (place.dimension == 1) return edges_[place.index].balance != 0;
  return place.dimension == 0 && open_vertex_[place.index];
}

DVec3 Surface::pseudonormal(Place place) const {
  DVec3 sum(0.0);
  for (TriangleIndex t : star(place)) {
    double weight = 1.0;
    if (place.dimension == 0) {
      const auto& c = triangles[t];
      const int k = static_cast<int>(std::find(c.begin(), c.end(), place.index) - c.begin());
      const DVec3 one = glm::normalize(positions[c[(k + 1) % 3]] - positions[c[k]]);
      const DVec3 other = glm::normalize(positions[c[(k + 2) % 3]] - positions[c[k]]);
      weight = std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
    }
    sum += weight * normals[t];
  }
  return sum;
}

double Surface::outwardness(Place place, const DVec3& u) const {
  if (skips_outward_test(place)) return 1.0;
  const DVec3 normal = pseudonormal(place);
  return glm::dot(u, normal) / std::max(1e-300, glm::length(normal));
}

}  // namespace palpate::oracle
