#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/mesh.h"

namespace palpate {

// A cone of directions at a vertex: it bounds the polar cone there.
struct VertexCone {
  Vec3 normal{0.0f};     // the pseudonormal, of unit length or zero
  float cosine = -1.0f;  // of the largest angle to an incident face's normal; negative: no bound

  bool bounds() const { return cosine >= 0.0f; }
};

// The shape of a surface apart from how it is cut into triangles: faces that continue each other are one flat
// patch, edges that continue each other one crease line, and vertices within either are none.
struct Creases {
  static constexpr std::uint32_t kNone = ~0u;

  // Faces and edges that turn by less than this (radians) continue each other; the faces of a patch differ
  // from its lowest one by no more, all together.
  static constexpr double kStraight = 1e-4;

  // A patch of more triangles than the first knows its border, if that has no more lines than the second.
  static constexpr std::size_t kMostWalked = 64;
  static constexpr std::size_t kMostBorders = 256;

  // That a crease line, named by its lowest edge, is on the border of a flat patch.
  struct Border {
    std::uint32_t patch;
    std::uint32_t line;

    auto operator<=>(const Border&) const = default;
  };

  enum class VertexRole : std::uint8_t { kFlat, kStraight, kCorner };

  std::vector<std::uint32_t> patch;  // by triangle: the lowest triangle of its flat patch
  std::vector<std::uint32_t> line;   // by edge: the lowest edge of its crease line; kNone within a patch
  std::vector<std::array<std::uint32_t, 2>> line_ends;  // by edge: vertices, kNone where a line is closed
  std::vector<VertexRole> role;                         // by vertex
  std::vector<VertexCone> cones;                        // by vertex
  std::vector<Border> borders;                          // in ascending order

  explicit Creases(const Mesh& mesh);

  bool is_flat(std::uint32_t edge) const { return line[edge] == kNone; }
  bool is_corner(std::uint32_t vertex) const { return role[vertex] == VertexRole::kCorner; }
  bool is_straight(std::uint32_t vertex) const { return role[vertex] == VertexRole::kStraight; }

  // What a feature is a part of: the patch of a face, the line of an edge, a vertex itself.
  Feature whole(const Feature& feature) const;

  // Of the patch of a triangle; none where that does not know them.
  std::span<const Border> borders_around(std::uint32_t triangle) const;

  std::size_t bytes() const;
};

}  // namespace palpate
