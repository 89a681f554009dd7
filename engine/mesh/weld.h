#pragma once

#include "engine/mesh/clean_triangles.h"

namespace palpate {

// The triangles of `soup` in `frame`, with vertices rounded to float32 there and equal ones (−0 equals 0)
// made one, numbered in the order of their first use. Indices must be in range and positions finite.
CleanTriangles weld_equal(const TriangleSoup& soup, const ModelFrame& frame);

// Goes through the vertices in order: each is welded to the earliest one kept that is within `tolerance`
// (normalised frame, > 0), or is kept. So no vertex moves farther than the tolerance and no chains form.
// Returns how many it welded.
std::uint64_t weld_near(CleanTriangles& surface, double tolerance);

}  // namespace palpate
