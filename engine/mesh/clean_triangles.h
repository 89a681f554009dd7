#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/result.h"
#include "engine/mesh/frame.h"
#include "engine/mesh/mesh_report.h"
#include "engine/mesh/triangle_soup.h"

namespace palpate {

struct MeshOptions {
  double weld_tolerance = 0.0;    // metres; 0 welds exactly equal positions only
  bool all_double_sided = false;  // skip the outward test everywhere
  bool keep_winding = false;      // trust the winding as it comes
};

// Welded triangles without degenerate or duplicate ones, wound as well as they can be.
struct CleanTriangles {
  ModelFrame frame;
  std::vector<Vec3> positions;             // normalised frame, every one used
  std::vector<TriangleIndices> triangles;  // counter-clockwise seen from outside
  std::vector<bool> double_sided;          // one flag a triangle
  std::vector<std::uint32_t> source;       // index of the triangle of the soup that each came from
};

// Welds, drops, repairs and orients `soup`, and writes what it did into `report`.
// Errors: kNonFinite, kInvalidArgument (index out of range, bad option), kNoTriangles.
Result<CleanTriangles> clean_triangles(const TriangleSoup& soup, const MeshOptions& options,
                                       MeshReport& report);

}  // namespace palpate
