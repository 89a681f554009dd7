#include "engine/mesh/soup_check.h"

#include <cmath>

#include "engine/mesh/edge_uses.h"

namespace palpate {
namespace {

Error index_error(std::size_t triangle, std::uint32_t vertex, std::size_t vertices) {
  return {ErrorCode::kInvalidArgument, "Triangle " + std::to_string(triangle) + " uses vertex " +
                                           std::to_string(vertex) + ", but there are only " +
                                           std::to_string(vertices) + " vertices."};
}

Error position_error(std::size_t triangle, std::uint32_t vertex) {
  return {ErrorCode::kNonFinite, "Vertex " + std::to_string(vertex) + ", which triangle " +
                                     std::to_string(triangle) + " uses, has a position that is not finite."};
}

bool finite(const DVec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Status check_sizes(const TriangleSoup& soup, const MeshOptions& options) {
  if (!(options.weld_tolerance >= 0) || !std::isfinite(options.weld_tolerance))
    return Error{ErrorCode::kInvalidArgument, "The weld tolerance must be finite and not negative."};
  if (!soup.double_sided.empty() && soup.double_sided.size() != soup.triangles.size())
    return Error{ErrorCode::kInvalidArgument,
                 "There must be one double-sided flag for each triangle, or none."};
  if (soup.triangles.size() > EdgeUses::kMaxTriangles)
    return Error{ErrorCode::kInvalidArgument, "There are " + std::to_string(soup.triangles.size()) +
                                                  " triangles, more than the " +
                                                  std::to_string(EdgeUses::kMaxTriangles) + " of the limit."};
  if (soup.triangles.empty()) return Error{ErrorCode::kNoTriangles, "There are no triangles."};
  return Done{};
}

}  // namespace

Result<Box> check_soup(const TriangleSoup& soup, const MeshOptions& options) {
  if (const Status sizes = check_sizes(soup, options); !sizes) return sizes.error();
  Box bounds;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    for (std::uint32_t vertex : soup.triangles[t]) {
      if (vertex >= soup.positions.size()) return index_error(t, vertex, soup.positions.size());
      if (!finite(soup.positions[vertex])) return position_error(t, vertex);
      bounds.grow(soup.positions[vertex]);
    }
  }
  if (!std::isfinite(bounds.diagonal()))
    return Error{ErrorCode::kNonFinite, "The model is too large: its diagonal is not a finite number."};
  return bounds;
}

}  // namespace palpate
