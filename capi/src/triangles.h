#pragma once

#include <cstdint>

#include "engine/mesh/triangle_soup.h"
#include "palpate/palpate.h"

namespace palpate::capi {

// Copies a caller's triangles into Palpate's space. Refuses impossible buffers, indices out of range and more
// than `max_triangles`.
TriangleSoup read_triangles(const plp_triangles& triangles, std::uint64_t max_triangles);

}  // namespace palpate::capi
