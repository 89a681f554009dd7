#include "engine/descent/polar_descent.h"

#include <algorithm>
#include <utility>

#include "engine/descent/fan_crossing.h"
#include "engine/mesh/polar_cone.h"

namespace palpate {
namespace {

// Leans within this many radians are left alone: what is left is decided by the feature test.
constexpr double kUpright = 1e-12;

// A descent that takes more steps than this looks whether it goes around a hub, and again after as many.
constexpr int kPatience = 8;

std::span<const std::uint32_t> triangles_around(const Mesh& mesh, Feature feature) {
  if (feature.kind == FeatureKind::kVertex) return mesh.vertex_triangles[feature.index];
  if (feature.kind == FeatureKind::kEdge) return mesh.edge_triangles[feature.index];
  return {};
}

// Tries other triangles in place of one or both; true when the point has moved.
class Mover {
 public:
  Mover(const DescentPair& pair, DescentPoint& point, DescentWork& work)
      : pair_(pair), point_(point), work_(work) {}

  bool move_to(TrianglePair triangles) {
    if (triangles == point_.triangles) return false;
    const DescentPoint next = pair_.measure(triangles, work_);
    if (!is_closer(next, point_)) return false;
    point_ = next;
    return true;
  }
  bool move_around(Feature feature_a, Feature feature_b) {
    for (std::uint32_t a : triangles_around(pair_.a(), feature_a))
      if (move_to({a, point_.triangles.b})) return true;
    for (std::uint32_t b : triangles_around(pair_.b(), feature_b))
      if (move_to({point_.triangles.a, b})) return true;
    return false;
  }

 private:
  const DescentPair& pair_;
  DescentPoint& point_;
  DescentWork& work_;
};

}  // namespace

bool PolarDescent::descend(const DescentPair& pair, DescentPoint& point, DescentWork& work) const {
  for (int i = 1; i <= kMaxDescentSteps; ++i) {
    if (!step(pair, point, work)) return true;
    ++work.steps;
    if (i % kPatience == 0) cross_fans(pair, point, work);
  }
  return false;
}

bool PolarDescent::step(const DescentPair& pair, DescentPoint& point, DescentWork& work) const {
  const DVec3 between = point.closest.on_second - point.closest.on_first;
  const double distance = glm::length(between);
  if (!(distance > 0)) return false;
  const DVec3 u = between / distance;
  const Feature feature_a = pair.feature_a(point), feature_b = pair.feature_b(point);
  const Lean lean_a = lean_at(pair.a(), feature_a, u);
  const Lean lean_b = lean_at(pair.b(), feature_b, pair.placement().into_b(-u));
  if (lean_a.amount <= kUpright && lean_b.amount <= kUpright) return false;

  Mover mover(pair, point, work);
  const TrianglePair now = point.triangles;
  TrianglePair first{lean_a.triangle, now.b}, second{now.a, lean_b.triangle};
  if (lean_b.amount > lean_a.amount) std::swap(first, second);
  return mover.move_to(first) || mover.move_to(second) || mover.move_to({lean_a.triangle, lean_b.triangle}) ||
         mover.move_around(feature_a, feature_b);
}

}  // namespace palpate
