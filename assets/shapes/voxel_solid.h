#pragma once

#include <cstdint>

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// How cubes of a voxel solid may touch.
enum class VoxelContact {
  kFaces,     // two cubes that share an edge or a corner are joined through faces around it: the surface is
              // manifold
  kAnything,  // also along a mere edge or at a mere corner: non-manifold edges and vertices
};

// The surface of random cubes of 0.02 m in a block of 8³: reflex edges, saddle and mixed vertices, right
// angles only.
TriangleSoup voxel_solid(std::uint64_t seed, VoxelContact contact = VoxelContact::kFaces);

}  // namespace palpate::shapes
