#include "samples/viewer/smooth_normals.h"

#include <glm/geometric.hpp>

namespace palpate::viewer {
namespace {

constexpr double kSharp = 0.8;  // cosine of the angle, about 37°, from which an edge is seen as one

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// For each vertex the triangles around it: from `first[v]` to `first[v + 1]`.
struct Around {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> triangles;

  Around(std::size_t vertices, const Triangles& of) : first(vertices + 1), triangles(3 * of.size()) {
    for (const auto& triangle : of)
      for (const std::uint32_t vertex : triangle) ++first[vertex + 1];
    for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t t = 0; t < of.size(); ++t)
      for (const std::uint32_t vertex : of[t]) triangles[next[vertex]++] = t;
  }
};

// As long as twice the triangle's area.
std::vector<Vec3> face_normals(const std::vector<Vec3>& vertices, const Triangles& triangles) {
  std::vector<Vec3> normals;
  normals.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
    normals.push_back(glm::cross(vertices[b] - vertices[a], vertices[c] - vertices[a]));
  return normals;
}

Vec3 unit(const Vec3& vector) {
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : Vec3(0.0);
}

}  // namespace

std::vector<glm::vec3> smooth_normals(const std::vector<Vec3>& vertices, const Triangles& triangles) {
  const std::vector<Vec3> faces = face_normals(vertices, triangles);
  const Around around(vertices.size(), triangles);
  std::vector<glm::vec3> normals;
  normals.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vec3 own = unit(faces[t]);
    for (const std::uint32_t vertex : triangles[t]) {
      Vec3 sum(0.0);
      for (std::uint32_t i = around.first[vertex]; i < around.first[vertex + 1]; ++i) {
        const Vec3& other = faces[around.triangles[i]];
        if (glm::dot(own, other) >= kSharp * glm::length(other)) sum += other;
      }
      normals.emplace_back(unit(sum));
    }
  }
  return normals;
}

}  // namespace palpate::viewer
