#pragma once

#include <cstdint>

#include "engine/mesh/mesh.h"

namespace palpate {

// Tells models apart by their vertices, triangles and sides, as they are searched.
std::uint64_t geometry_hash(const Mesh& mesh);

}  // namespace palpate
