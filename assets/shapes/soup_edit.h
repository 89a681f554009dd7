#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// Puts a part beside what is there; no vertex is shared between the two.
void append(TriangleSoup& soup, const TriangleSoup& part);

void turn_inside_out(TriangleSoup& soup);

void translate(TriangleSoup& soup, const DVec3& offset);

// A file stores float32: what a test computes with must be what a reader of the file gets. −0 becomes 0.
TriangleSoup rounded_to_float32(TriangleSoup soup);

// Rounds to float32 and makes one vertex of all with exactly equal positions, in the order of their first
// use.
TriangleSoup welded(const TriangleSoup& soup);

}  // namespace palpate::shapes
