#include "engine/descent/descent_pair.h"

namespace palpate {

Feature feature_at(const Mesh& mesh, std::uint32_t triangle, TrianglePlace place) {
  if (place.is_corner()) return {FeatureKind::kVertex, mesh.triangles[triangle][place.code]};
  if (place.is_side()) return {FeatureKind::kEdge, mesh.triangle_edges[triangle][place.side()]};
  return {FeatureKind::kFace, triangle};
}

DescentPoint DescentPair::measure(TrianglePair triangles, DescentWork& work) const {
  ++work.triangle_pairs;
  return {triangles, closest_points(triangle_of(a_, triangles.a), triangle_of(b_, triangles.b, placement_))};
}

Feature DescentPair::feature_a(const DescentPoint& point) const {
  return feature_at(a_, point.triangles.a, point.closest.first_place);
}

Feature DescentPair::feature_b(const DescentPoint& point) const {
  return feature_at(b_, point.triangles.b, point.closest.second_place);
}

}  // namespace palpate
