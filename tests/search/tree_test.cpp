// The hierarchy's own promises: every triangle once, bounds that hold.
#include "engine/snch/tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <thread>

#include "assets/catalogue.h"
#include "engine/mesh/polar_cone.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

void collect(const Tree& tree, std::uint32_t node, std::vector<std::uint32_t>& triangles) {
  if (tree.node(node).is_leaf()) return triangles.push_back(tree.node(node).triangle());
  collect(tree, node + 1, triangles);
  collect(tree, tree.node(node).second_child(), triangles);
}

// The node's cone holds a direction, by the sine of its angle, which is exact also where that is small.
void expect_in_cone(const Node& node, const DVec3& direction) {
  const DVec3 axis(node.cone_axis);
  const double angle = std::atan2(glm::length(glm::cross(axis, direction)), glm::dot(axis, direction));
  ASSERT_LE(angle, std::atan2(node.cone_sine, node.cone_cosine));
}

// The normals of all triangles at a feature that its owner brings into the search.
void expect_normals(const Mesh& mesh, const Node& node, const Feature& feature) {
  for (std::uint32_t t : triangles_at(mesh, feature)) expect_in_cone(node, unit_normal(mesh, t));
}

void expect_cone(const Tree& tree, const Mesh& mesh, const Node& node, std::uint32_t t) {
  if (node.cone_cosine < 0) return;
  expect_in_cone(node, unit_normal(mesh, t));
  const OwnedFeatures owned = tree.owned(t);
  for (int k = 0; k < 3; ++k) {
    if (owned.corners & (1u << k)) expect_normals(mesh, node, {FeatureKind::kVertex, mesh.triangles[t][k]});
    if (owned.sides & (1u << k)) expect_normals(mesh, node, {FeatureKind::kEdge, mesh.triangle_edges[t][k]});
  }
}

void expect_bounds(const Tree& tree, const Mesh& mesh, const Node& node,
                   const std::vector<std::uint32_t>& triangles) {
  for (std::uint32_t t : triangles) {
    for (std::uint32_t vertex : mesh.triangles[t]) {
      const DVec3 arm = mesh.position(vertex) - DVec3(node.centre);
      ASSERT_LE(glm::length(arm), node.radius);
      for (int k = 0; k < 3; ++k) ASSERT_LE(std::abs(arm[k]), node.half[k]);
    }
    expect_cone(tree, mesh, node, t);
  }
}

void expect_bounds(const Tree& tree, const Mesh& mesh) {
  for (std::uint32_t i = 0; i < tree.node_count(); ++i) {
    std::vector<std::uint32_t> below;
    collect(tree, i, below);
    expect_bounds(tree, mesh, tree.node(i), below);
  }
}

TEST(Tree, BoundsAndHoldsEveryTriangleOnce) {
  for (const char* name : {"organic_2200", "voxels", "fan_200", "mobius_strip", "slivers", "tetrahedron"}) {
    const auto model = asset_model(name);
    const Tree& tree = model->tree();
    std::vector<std::uint32_t> all;
    collect(tree, 0, all);
    std::sort(all.begin(), all.end());
    ASSERT_EQ(all.size(), model->mesh().triangles.size()) << name;
    for (std::uint32_t t = 0; t < all.size(); ++t) ASSERT_EQ(all[t], t);
    ASSERT_EQ(tree.node_count(), 2 * all.size() - 1);
    expect_bounds(tree, model->mesh());
    expect_bounds(model->near_tree().tree, model->mesh());
  }
}

TEST(Tree, BoundsAtAnyScaleAndPlace) {
  constexpr std::uint64_t kSeed = 1009;
  Random random(kSeed);
  for (double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    for (double offset : {0.0, 0.7, 3.0, 1e4}) {
      TriangleSoup soup = find_asset("organic_2200")->make();
      const DMat3 turn = random.rotation();
      const DVec3 away = offset * random.direction();
      for (DVec3& position : soup.positions) position = scale * (turn * position + away);
      const auto model = make_model(soup);
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", scale " + std::to_string(scale) + ", offset " +
                   std::to_string(offset));
      expect_bounds(model->tree(), model->mesh());
    }
  }
}

// All that a model keeps for a search by either law. Near minima need to know the creases besides.
TEST(Tree, TakesLessThanTwoHundredBytesATriangle) {
  const auto model = asset_model("organic_97k");
  const double triangles = static_cast<double>(model->mesh().triangles.size());
  const double mesh = static_cast<double>(model->mesh().bytes()) / triangles;
  const double tree = static_cast<double>(model->tree().bytes()) / triangles;
  const double near_tree = static_cast<double>(model->near_tree().bytes()) / triangles;
  std::printf("bytes a triangle: mesh %.1f, tree %.1f, tree and creases for near minima %.1f\n", mesh, tree,
              near_tree);
  EXPECT_LT(mesh + tree, 161.0);
  EXPECT_LT(mesh + near_tree, 192.0);
}

TEST(Tree, EveryFeatureThatMayHoldAMinimumIsOwnedOnce) {
  const auto model = asset_model("voxels_nonmanifold");
  const Mesh& mesh = model->mesh();
  std::size_t corners = 0, sides = 0, active_vertices = 0, active_edges = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    corners += static_cast<std::size_t>(__builtin_popcount(model->tree().owned(t).corners));
    sides += static_cast<std::size_t>(__builtin_popcount(model->tree().owned(t).sides));
  }
  for (FeatureFlags flags : mesh.vertex_flags) active_vertices += flags.active;
  for (FeatureFlags flags : mesh.edge_flags) active_edges += flags.active;
  EXPECT_EQ(corners, active_vertices);
  EXPECT_EQ(sides, active_edges);
  EXPECT_LT(active_edges, mesh.edges.size());
}

TEST(Tree, OneTriangleIsARootThatIsALeaf) {
  TriangleSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}};
  const auto model = make_model(soup);
  EXPECT_EQ(model->tree().node_count(), 1u);
  EXPECT_TRUE(model->tree().root().is_leaf());
}

TEST(Tree, IsBuiltOnceWhenFirstAskedFor) {
  const auto model = asset_model("organic_2200");
  EXPECT_EQ(model->tree_if_built(), nullptr);
  const Tree* seen[2] = {};
  std::thread other([&] { seen[0] = &model->tree(); });
  seen[1] = &model->tree();
  other.join();
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_EQ(model->tree_if_built(), seen[0]);
}

// Sizes that halve from triangle to triangle drive the surface area heuristic into its deepest trees.
TEST(Tree, SurvivesGeometricProgressions) {
  TriangleSoup soup;
  double size = 1.0;
  for (std::uint32_t i = 0; i < 120; ++i, size *= 0.5) {
    soup.positions.insert(soup.positions.end(), {{size, 0, 0}, {size, size, 0}, {size, 0, size}});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto model = make_model(soup);
  EXPECT_EQ(model->tree().node_count(), 2 * model->mesh().triangles.size() - 1);
}

}  // namespace
}  // namespace palpate
