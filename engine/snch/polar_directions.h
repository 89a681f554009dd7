#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/creases.h"

namespace palpate {

// For triangles in a given order, unit directions whose convex cone holds every direction in which a local
// minimum distance can leave the triangle or an edge or vertex that it owns.
//
// The outward polar cone of a manifold vertex, saddles and mixed ones included, lies in the convex cone of
// the normals of its faces, as does that of an edge. Reflex edges and pits hold no LMD and add nothing.
// Features that skip the outward test are not bounded: their triangle is `unbounded`.
//
// With creases the directions of near minima are bounded too, up to the smoothing angle: those at a vertex
// by its cone.
struct PolarDirections {
  std::vector<Vec3> directions;
  std::vector<std::uint32_t> begin;     // by rank in the order; one more at the end
  std::vector<std::uint8_t> unbounded;  // by rank

  PolarDirections(const Mesh& mesh, std::span<const std::uint32_t> order, const Creases* creases = nullptr);

  std::span<const Vec3> of(std::uint32_t first_rank, std::uint32_t end_rank) const {
    return {directions.data() + begin[first_rank], directions.data() + begin[end_rank]};
  }
};

}  // namespace palpate
