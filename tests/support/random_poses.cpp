#include "tests/support/random_poses.h"

#include <cmath>
#include <numbers>

namespace palpate {
namespace {

bool overlapping(const Model& a, const Model& b, const Pose& pose) {
  LmdSearch search;
  LmdSet found;
  SearchOptions options;
  options.cutoff = 1e-9 * a.radius();
  options.max_overlaps = 1;
  search.run(a, b, pose, options, found);
  return found.overlapping();
}

}  // namespace

DVec3 Random::direction() {
  const double z = uniform(-1.0, 1.0), angle = uniform(0.0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// Uniform over rotations (Shoemake 1992).
DMat3 Random::rotation() {
  const double u = uniform(0.0, 1.0), angle = uniform(0.0, 2 * std::numbers::pi),
               other = uniform(0.0, 2 * std::numbers::pi);
  const double s = std::sqrt(1 - u), t = std::sqrt(u);
  return glm::mat3_cast(
      DQuat(t * std::cos(other), s * std::sin(angle), s * std::cos(angle), t * std::sin(other)));
}

Pose place_near(const Model& a, const Model& b, double gap, Random& random) {
  const DMat3 rotation = random.rotation();
  const DVec3 direction = random.direction();
  const auto vertex = [&](const Model& model) {
    const Mesh& mesh = model.mesh();
    return mesh.frame.metres(mesh.position(random.below(mesh.positions.size())));
  };
  // One after the other, so that a seed names the same pose whatever the compiler.
  const DVec3 of_b = rotation * vertex(b);
  const DVec3 meeting = vertex(a) - of_b;
  double inside = 0.0, outside = 2.1 * (a.radius() + b.radius());
  const auto pose_at = [&](double along) { return Pose{rotation, meeting + direction * along}; };
  while (outside - inside > 1e-9 * (a.radius() + b.radius())) {
    const double middle = 0.5 * (inside + outside);
    (overlapping(a, b, pose_at(middle)) ? inside : outside) = middle;
  }
  return pose_at(outside + gap);
}

}  // namespace palpate
