#pragma once

#include "engine/mesh/clean_triangles.h"

namespace palpate {

// Drops triangles that have the three vertices of an earlier one, and counts them. The earlier one becomes
// double-sided if one that is dropped is so or is wound the other way: a sheet that was modelled as two
// layers.
void drop_duplicates(CleanTriangles& surface, MeshReport& report);

}  // namespace palpate
