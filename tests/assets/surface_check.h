#pragma once

#include <cstddef>
#include <vector>

#include "engine/mesh/triangle_soup.h"

namespace palpate::test {

// Counts over the stored vertices, written independently of the engine's own checks.
struct SurfaceCheck {
  std::size_t equal_positions = 0;       // stored vertices beyond the first at one place
  std::size_t degenerate_triangles = 0;  // two corners are one vertex
  std::size_t boundary_edges = 0;
  std::size_t nonmanifold_edges = 0;   // three triangles or more
  std::size_t inconsistent_edges = 0;  // two triangles that run the same way
  std::size_t pinched_vertices = 0;    // the triangles around it are not one fan
  std::vector<double> volumes;         // signed, one a component
  double sharpest_edge = 1.0;          // smallest cosine between the normals of neighbours; −1 is a fold

  bool closed_manifold() const {
    return equal_positions + degenerate_triangles + boundary_edges + nonmanifold_edges + inconsistent_edges +
               pinched_vertices ==
           0;
  }
};

SurfaceCheck check_surface(const TriangleSoup& soup);

// Longest side over shortest height, the largest of all triangles with an area.
double worst_aspect(const TriangleSoup& soup);

}  // namespace palpate::test
