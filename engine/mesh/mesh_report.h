#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palpate {

enum class Orientation { kOpen, kOutward, kInward, kMixed };

// Counts of a surface. Vertices are welded: exactly equal positions are one vertex (−0 equals 0). Edges are
// counted over triangles whose three welded corners differ.
struct SurfaceCounts {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t boundary_edges = 0;      // one triangle
  std::uint64_t nonmanifold_edges = 0;   // more than two triangles
  std::uint64_t inconsistent_edges = 0;  // two triangles that run the same way
  std::uint64_t components = 0;          // sets of triangles joined through shared vertices
  Orientation orientation = Orientation::kOpen;

  bool watertight() const { return boundary_edges + nonmanifold_edges + inconsistent_edges == 0; }
};

// What a model was when it came and what was done to it.
struct MeshReport {
  SurfaceCounts source;  // as it came, welded only
  SurfaceCounts final;   // as it is searched
  std::uint64_t stored_vertices = 0;
  std::uint64_t degenerate_triangles = 0;  // two equal corners, or an area of exactly zero
  std::uint64_t duplicate_triangles = 0;   // the same three vertices, in any order, as an earlier one
  std::uint64_t split_triangles =
      0;  // neighbours of dropped zero-area triangles, split at their middle vertex
  std::uint64_t reversed_triangles = 0;  // winding reversed, to agree with neighbours or to face outward
  std::uint64_t flipped_components = 0;  // closed components that faced the wrong way
  std::uint64_t double_sided_triangles = 0;
  std::vector<std::string> notes;  // one sentence for each thing that was repaired, kept or skipped
};

}  // namespace palpate
