#include "engine/mesh/clean_triangles.h"

#include <algorithm>

#include "engine/mesh/degenerate.h"
#include "engine/mesh/duplicate.h"
#include "engine/mesh/report_notes.h"
#include "engine/mesh/soup_check.h"
#include "engine/mesh/surface_counts.h"
#include "engine/mesh/triangle_filter.h"
#include "engine/mesh/weld.h"
#include "engine/mesh/winding.h"

namespace palpate {
namespace {

// Vertices that all lie in one point span no frame; any will do to find that no triangle has an area.
ModelFrame frame_around(const Box& bounds) {
  return bounds.diagonal() > 0 ? frame_of(bounds) : ModelFrame{bounds.low, 1.0};
}

void weld_within(double tolerance, CleanTriangles& surface, MeshReport& report) {
  const std::uint64_t welded = weld_near(surface, tolerance / surface.frame.scale);
  if (welded > 0)
    report.notes.push_back("Welded " + counted(welded, "vertex", "vertices") +
                           " to others within the tolerance.");
}

}  // namespace

Result<CleanTriangles> clean_triangles(const TriangleSoup& soup, const MeshOptions& options,
                                       MeshReport& report) {
  report = MeshReport{};
  const Result<Box> bounds = check_soup(soup, options);
  if (!bounds) return bounds.error();

  CleanTriangles surface = weld_equal(soup, frame_around(bounds.value()));
  report.stored_vertices = soup.positions.size();
  report.source = count_surface(surface.positions, surface.triangles);
  if (options.weld_tolerance > 0) weld_within(options.weld_tolerance, surface, report);

  drop_degenerate(surface, report);
  drop_duplicates(surface, report);
  if (surface.triangles.empty()) return Error{ErrorCode::kNoTriangles, "No triangle has an area."};
  if (!options.keep_winding) orient(surface, report);
  if (options.all_double_sided) surface.double_sided.assign(surface.triangles.size(), true);

  drop_unused_vertices(surface);
  report.final = count_surface(surface.positions, surface.triangles);
  report.double_sided_triangles = std::ranges::count(surface.double_sided, true);
  add_notes(report);
  return surface;
}

}  // namespace palpate
