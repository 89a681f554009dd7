#include "engine/mesh/degenerate.h"

#include <algorithm>

#include "engine/mesh/area.h"
#include "engine/mesh/slivers.h"
#include "engine/mesh/triangle_filter.h"

namespace palpate {
namespace {

std::vector<std::uint32_t> slivers_of(const CleanTriangles& surface) {
  std::vector<std::uint32_t> slivers;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    if (has_no_area(surface.positions, surface.triangles[t])) slivers.push_back(t);
  return slivers;
}

}  // namespace

bool has_no_area(const std::vector<Vec3>& positions, const TriangleIndices& triangle) {
  // Not by glm's ==, which compares bits and so takes −0 for something else than 0.
  const DVec3 area = area_vector(positions, triangle);
  return area.x == 0 && area.y == 0 && area.z == 0;
}

void drop_degenerate(CleanTriangles& surface, MeshReport& report) {
  report.degenerate_triangles =
      drop_triangles_if(surface, [&](std::uint32_t t) { return has_equal_corners(surface.triangles[t]); });
  const std::vector<std::uint32_t> slivers = slivers_of(surface);
  if (slivers.empty()) return;
  report.degenerate_triangles += slivers.size();
  report.split_triangles = split_beside_slivers(surface, slivers);
  drop_triangles_if(surface,
                    [&](std::uint32_t t) { return has_no_area(surface.positions, surface.triangles[t]); });
}

}  // namespace palpate
