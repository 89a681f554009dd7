#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/creases.h"
#include "engine/snch/point_list.h"

namespace palpate {

// Unit directions whose convex cone holds every direction in which a local minimum distance can leave a
// triangle or an edge or vertex that it owns.
//
// The outward polar cone of a manifold vertex, saddles and mixed ones included, lies in the convex cone of
// the normals of its faces, as does that of an edge. Reflex edges and pits hold no LMD and add nothing.
// Features that skip the outward test are not bounded, nor is their triangle.
//
// With creases the directions of near minima are bounded too, up to the smoothing angle: those at a vertex
// by its cone.
class PolarDirections {
 public:
  PolarDirections(const Mesh& mesh, const Creases* creases);

  // Adds those of one triangle; false if they have no bound.
  bool add(std::uint32_t triangle, PointList& directions) const;

 private:
  bool add_edge(std::uint32_t triangle, std::uint32_t edge, PointList& directions) const;
  bool add_vertex(std::uint32_t triangle, std::uint32_t vertex, PointList& directions) const;
  void add_normals(std::uint32_t own, std::span<const std::uint32_t> triangles, PointList& directions) const;

  const Mesh& mesh_;
  const Creases* creases_;  // null: no near minima
  std::vector<Vec3> normals_;
};

}  // namespace palpate
