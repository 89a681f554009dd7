#pragma once

#include "engine/mesh/clean_triangles.h"

namespace palpate {

// Winds the triangles of each patch (patches.h) alike, as the larger part of its area is wound, and makes
// closed patches face outward, cavities inward. A closed patch inside another that faced the other way is a
// cavity in it, or a solid in a cavity. Patches that cannot be wound consistently stay as they are and get a
// note. Needs a surface without degenerate and duplicate triangles.
void orient(CleanTriangles& surface, MeshReport& report);

}  // namespace palpate
