// Whether a direction leaves the solid: what is asked of the triangles first answers as the pseudonormal
// does.
#include <gtest/gtest.h>

#include "engine/mesh/polar_cone.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 57;

class Outward : public testing::TestWithParam<const char*> {};

TEST_P(Outward, IsWhatThePseudonormalSays) {
  const auto model = asset_model(GetParam());
  const Mesh& mesh = model->mesh();
  Random random(kSeed);
  int leaving = 0, entering = 0;
  const auto expect_same = [&](bool leaves, const DVec3& pseudonormal, const DVec3& u) {
    EXPECT_EQ(leaves, glm::dot(u, pseudonormal) > 0) << "seed " << kSeed;
    ++(leaves ? leaving : entering);
  };
  for (int i = 0; i < 5000; ++i) {
    // Half of them near a normal, where every triangle is left.
    const std::uint32_t vertex = random.below(mesh.positions.size()), edge = random.below(mesh.edges.size());
    const DVec3 normal = unit_normal(mesh, mesh.owner_of_vertex(vertex));
    const DVec3 u = glm::normalize(random.direction() + (i % 2 ? 3.0 : 0.0) * normal);
    expect_same(leaves_at_vertex(mesh, vertex, u), vertex_pseudonormal(mesh, vertex), u);
    expect_same(leaves_at_edge(mesh, edge, u), edge_pseudonormal(mesh, edge), u);
  }
  EXPECT_GT(leaving, 1000);
  EXPECT_GT(entering, 1000);
}

INSTANTIATE_TEST_SUITE_P(Assets, Outward,
                         testing::Values("organic_2200", "crankshaft_45k", "saddle", "slivers", "voxels"));

}  // namespace
}  // namespace palpate
