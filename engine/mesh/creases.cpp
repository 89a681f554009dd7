#include "engine/mesh/creases.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "engine/mesh/polar_cone.h"

namespace palpate {
namespace {

// A cone that is wider than this bounds nothing that a node's cone could use.
constexpr double kWidestCosine = 0.3;

bool continues(const DVec3& one, const DVec3& other) {
  return glm::dot(one, other) > 0 && glm::length(glm::cross(one, other)) < Creases::kStraight;
}

class CreaseFinder {
 public:
  CreaseFinder(const Mesh& mesh, Creases& creases) : mesh_(mesh), creases_(creases) {}

  void find() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) normals_.push_back(unit_normal(mesh_, t));
    find_patches();
    find_roles();
    find_lines();
    find_cones();
    find_borders();
  }

 private:
  void find_patches() {
    creases_.patch.resize(mesh_.triangles.size());
    std::iota(creases_.patch.begin(), creases_.patch.end(), 0u);
    creases_.line.assign(mesh_.edges.size(), Creases::kNone);
    turn_.assign(mesh_.triangles.size(), 0.0);
    for (std::uint32_t edge = 0; edge < mesh_.edges.size(); ++edge) {
      const auto triangles = mesh_.edge_triangles[edge];
      if (!within_patch(triangles) || !unite(triangles[0], triangles[1])) creases_.line[edge] = edge;
    }
    for (std::uint32_t t = 0; t < creases_.patch.size(); ++t) creases_.patch[t] = root_of(t);
  }

  bool within_patch(std::span<const std::uint32_t> triangles) const {
    return triangles.size() == 2 && mesh_.double_sided[triangles[0]] == mesh_.double_sided[triangles[1]] &&
           continues(normals_[triangles[0]], normals_[triangles[1]]);
  }

  // Unless the patch would turn too much: many slight turns add up to a cone around a vertex, whose tip is no
  // part of a flat face, or to a ball.
  bool unite(std::uint32_t one, std::uint32_t other) {
    one = root_of(one);
    other = root_of(other);
    if (one == other) return true;
    if (one > other) std::swap(one, other);
    const double turn = glm::length(glm::cross(normals_[one], normals_[other])) + turn_[other];
    if (!continues(normals_[one], normals_[other]) || turn > Creases::kStraight) return false;
    turn_[one] = std::max(turn_[one], turn);
    creases_.patch[other] = one;
    return true;
  }

  std::uint32_t root_of(std::uint32_t t) {
    while (creases_.patch[t] != t) t = creases_.patch[t] = creases_.patch[creases_.patch[t]];
    return t;
  }

  void find_roles() {
    at_vertex_.assign(mesh_.positions.size(), {Creases::kNone, Creases::kNone});
    std::vector<std::uint8_t> count(mesh_.positions.size(), 0);
    for (std::uint32_t edge = 0; edge < mesh_.edges.size(); ++edge) {
      if (creases_.is_flat(edge)) continue;
      for (std::uint32_t vertex : mesh_.edges[edge].vertex) {
        if (count[vertex] < 2) at_vertex_[vertex][count[vertex]] = edge;
        count[vertex] = static_cast<std::uint8_t>(std::min(count[vertex] + 1, 3));
      }
    }
    creases_.role.assign(mesh_.positions.size(), Creases::VertexRole::kCorner);
    for (std::uint32_t vertex = 0; vertex < count.size(); ++vertex) {
      if (count[vertex] == 0) creases_.role[vertex] = Creases::VertexRole::kFlat;
      if (count[vertex] == 2 && is_straight(vertex)) creases_.role[vertex] = Creases::VertexRole::kStraight;
    }
  }

  bool is_straight(std::uint32_t vertex) const {
    const auto [one, other] = at_vertex_[vertex];
    return continues(away(one, vertex), -away(other, vertex));
  }

  DVec3 away(std::uint32_t edge, std::uint32_t from) const {
    return glm::normalize(mesh_.position(far_end(edge, from)) - mesh_.position(from));
  }

  std::uint32_t far_end(std::uint32_t edge, std::uint32_t from) const {
    const auto [one, other] = mesh_.edges[edge].vertex;
    return from == one ? other : one;
  }

  // In ascending order, so that the first edge met of a line is its lowest.
  void find_lines() {
    creases_.line_ends.assign(mesh_.edges.size(), {Creases::kNone, Creases::kNone});
    std::vector<bool> known(mesh_.edges.size(), false);
    std::vector<std::uint32_t> members;
    for (std::uint32_t edge = 0; edge < mesh_.edges.size(); ++edge) {
      if (creases_.is_flat(edge) || known[edge]) continue;
      members.assign(1, edge);
      const std::array<std::uint32_t, 2> ends{follow(edge, mesh_.edges[edge].vertex[0], members),
                                              follow(edge, mesh_.edges[edge].vertex[1], members)};
      for (std::uint32_t member : members) {
        known[member] = true;
        creases_.line[member] = edge;
        creases_.line_ends[member] = ends;
      }
    }
  }

  // The end of a line that runs through `vertex`, adding its edges on the way.
  std::uint32_t follow(std::uint32_t first, std::uint32_t vertex, std::vector<std::uint32_t>& members) const {
    for (std::uint32_t edge = first; creases_.role[vertex] == Creases::VertexRole::kStraight;) {
      edge = at_vertex_[vertex][0] == edge ? at_vertex_[vertex][1] : at_vertex_[vertex][0];
      if (edge == first) return Creases::kNone;
      members.push_back(edge);
      vertex = far_end(edge, vertex);
    }
    return vertex;
  }

  // A manifold vertex has as many neighbours as triangles. In float32 the normals hide what mathematical
  // libraries differ in.
  void find_cones() {
    creases_.cones.resize(mesh_.positions.size());
    for (std::uint32_t vertex = 0; vertex < creases_.cones.size(); ++vertex) {
      VertexCone& cone = creases_.cones[vertex];
      const DVec3 sum = vertex_pseudonormal(mesh_, vertex);
      const double length = glm::length(sum);
      if (!(length > 1e-6)) continue;
      cone.normal = Vec3(sum / length);
      const auto triangles = mesh_.vertex_triangles[vertex];
      if (!mesh_.vertex_flags[vertex].outward || triangles.size() != mesh_.vertex_neighbours[vertex].size())
        continue;
      double least = 1.0;
      for (std::uint32_t t : triangles) least = std::min(least, glm::dot(normals_[t], DVec3(cone.normal)));
      if (least > kWidestCosine) cone.cosine = std::nextafter(static_cast<float>(least), 0.0f);
    }
  }

  void find_borders() {
    std::vector<std::uint32_t> size(mesh_.triangles.size(), 0);  // by patch
    for (const std::uint32_t patch : creases_.patch) ++size[patch];
    std::vector<Creases::Border>& borders = creases_.borders;
    for (std::uint32_t edge = 0; edge < mesh_.edges.size(); ++edge) {
      if (creases_.is_flat(edge)) continue;
      for (const std::uint32_t triangle : mesh_.edge_triangles[edge])
        if (size[creases_.patch[triangle]] > Creases::kMostWalked)
          borders.push_back({creases_.patch[triangle], creases_.line[edge]});
    }
    std::sort(borders.begin(), borders.end());
    borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
    drop_long_borders();
  }

  // Also those with a line that has no ends, which is no straight one.
  void drop_long_borders() {
    std::vector<Creases::Border>& borders = creases_.borders;
    auto kept = borders.begin();
    for (auto begin = borders.begin(), end = begin; begin != borders.end(); begin = end) {
      end = std::find_if(begin, borders.end(),
                         [&](const Creases::Border& border) { return border.patch != begin->patch; });
      if (end - begin > static_cast<std::ptrdiff_t>(Creases::kMostBorders)) continue;
      if (std::any_of(begin, end, [&](const Creases::Border& border) { return is_closed(border.line); }))
        continue;
      kept = std::copy(begin, end, kept);
    }
    borders.erase(kept, borders.end());
    borders.shrink_to_fit();
  }

  bool is_closed(std::uint32_t line) const { return creases_.line_ends[line][0] == Creases::kNone; }

  const Mesh& mesh_;
  Creases& creases_;
  std::vector<DVec3> normals_;
  std::vector<double> turn_;  // by lowest triangle of a patch: no other's normal differs from its own by more
  std::vector<std::array<std::uint32_t, 2>> at_vertex_;  // its first two crease edges
};

template <class T>
std::size_t bytes_of(const std::vector<T>& items) {
  return items.size() * sizeof(T);
}

}  // namespace

Creases::Creases(const Mesh& mesh) {
  CreaseFinder(mesh, *this).find();
}

Feature Creases::whole(const Feature& feature) const {
  if (feature.kind == FeatureKind::kFace) return {feature.kind, patch[feature.index]};
  if (feature.kind == FeatureKind::kEdge && !is_flat(feature.index))
    return {feature.kind, line[feature.index]};
  return feature;
}

std::span<const Creases::Border> Creases::borders_around(std::uint32_t triangle) const {
  const auto [begin, end] =
      std::equal_range(borders.begin(), borders.end(), Border{patch[triangle], 0},
                       [](const Border& one, const Border& other) { return one.patch < other.patch; });
  return {begin, end};
}

std::size_t Creases::bytes() const {
  return bytes_of(patch) + bytes_of(line) + bytes_of(line_ends) + bytes_of(role) + bytes_of(cones) +
         bytes_of(borders);
}

}  // namespace palpate
