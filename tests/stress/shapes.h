#pragma once

#include "engine/mesh/triangle_soup.h"
#include "tests/support/random_poses.h"

namespace palpate::stress {

// A prism along x whose sharp edge, at the origin, points up: its roof falls by `height` over `half_width`.
TriangleSoup prism(double length, double half_width, double height);

// A tetrahedron over a triangle of length 1 and width `width`.
TriangleSoup fin(double height, double width);

// A tetrahedron of that length, and about `width` wide across it.
TriangleSoup needle(double length, double width);

// A bar whose upper side is cut into strips across, each `width` wide, of a length of 1.
TriangleSoup sliver_row(double width, int strips);

// A pyramid over a regular polygon: its tip has this valence. Negative heights make a dent in a block.
TriangleSoup spike(int valence, double height);

// Triangles at random, joined side to side: an open surface.
TriangleSoup strip_of_triangles(int count, Random& random);

// Triangles without area on sides, between corners that are there; triangles once more, as they are or
// turned round; sides cut for one of their triangles only; corners moved at random.
void add_zero_area(TriangleSoup& soup, Random& random);
void add_duplicates(TriangleSoup& soup, Random& random);
void add_t_junctions(TriangleSoup& soup, Random& random);
void add_noise(TriangleSoup& soup, double size, Random& random);

}  // namespace palpate::stress
