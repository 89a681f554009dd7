#include "engine/gltf/gltf_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "tests/gltf/gltf_builder.h"

namespace palpate::test {
namespace {

GltfOptions with_hierarchy() {
  GltfOptions options;
  options.hierarchy = true;
  return options;
}

Result<GltfBodies> bodies_of(const GltfBuilder& builder, const std::string& tool = {}) {
  const Result<GltfScene> scene = read(builder, with_hierarchy());
  if (!scene) return scene.error();
  return gather_bodies(scene.value(), tool, {});
}

GltfBodies good(const GltfBuilder& builder, const std::string& tool = {}) {
  Result<GltfBodies> bodies = bodies_of(builder, tool);
  EXPECT_TRUE(bodies.ok()) << bodies.error().message;
  return bodies.ok() ? std::move(bodies.value()) : GltfBodies{};
}

Error error_of(const GltfBuilder& builder, const std::string& tool = {}) {
  const Result<GltfBodies> bodies = bodies_of(builder, tool);
  EXPECT_FALSE(bodies.ok());
  return bodies.ok() ? Error{ErrorCode::kInternal, ""} : bodies.error();
}

// One triangle that nodes may show as mesh 0, and no node yet.
GltfBuilder no_nodes() {
  GltfBuilder builder = triangle_builder();
  builder.json["nodes"] = Json::array();
  builder.json["scenes"][0]["nodes"] = Json::array();
  return builder;
}

// A node below another, which is no root.
int add_child(GltfBuilder& builder, int parent, Json node) {
  builder.json["nodes"].push_back(std::move(node));
  const int index = static_cast<int>(builder.json["nodes"].size()) - 1;
  builder.json["nodes"][static_cast<std::size_t>(parent)]["children"].push_back(index);
  return index;
}

// The corners of a body's model in the scene, by triangle.
std::vector<DVec3> corners_of(const GltfBodies& bodies, const GltfBody& body) {
  const Mesh& mesh = bodies.shapes[body.shape];
  std::vector<DVec3> corners;
  for (const TriangleIndices& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle)
      corners.push_back(body.scene_from_body * mesh.frame.metres(mesh.position(corner)));
  }
  return corners;
}

TEST(Bodies, HaveTheNamesAndTheOrderOfTheirNodes) {
  GltfBuilder builder = no_nodes();
  const int base = builder.add_node({{"name", "base"}, {"mesh", 0}});
  const int joint = add_child(builder, base, {{"translation", {1, 0, 0}}});
  add_child(builder, joint, {{"name", "arm"}, {"mesh", 0}, {"translation", {0, 2, 0}}});
  builder.add_node({{"name", "floor"}, {"mesh", 0}});
  const GltfBodies found = good(builder);
  ASSERT_EQ(found.bodies.size(), 3u);
  EXPECT_EQ(found.bodies[0].name, "base");
  EXPECT_EQ(found.bodies[1].name, "arm");
  EXPECT_EQ(found.bodies[1].node, 2u);
  EXPECT_EQ(found.bodies[1].above, 0);
  EXPECT_EQ(found.bodies[1].scene_from_body.translation, DVec3(1, 2, 0));
  EXPECT_EQ(DVec3(found.bodies[1].above_from_parent[3]), DVec3(1, 0, 0));
  EXPECT_EQ(found.bodies[2].name, "floor");
  EXPECT_EQ(found.bodies[2].above, -1);
  EXPECT_EQ(found.shapes.size(), 1u);
}

TEST(Bodies, WithoutANameHaveThatOfTheirMesh) {
  GltfBuilder builder = no_nodes();
  builder.json["meshes"][0]["name"] = "part";
  builder.add_node({{"name", "mine"}, {"mesh", 0}});
  builder.add_node({{"mesh", 0}});
  const GltfBodies found = good(builder, "part");
  EXPECT_EQ(found.bodies[0].name, "mine");
  EXPECT_EQ(found.bodies[1].name, "part");
  EXPECT_TRUE(found.bodies[1].tool);
}

TEST(Bodies, ToolIsFoundByItsIndexUnlessANodeIsCalledSo) {
  GltfBuilder builder = no_nodes();
  builder.add_node({{"mesh", 0}});
  builder.add_node({{"name", "pen"}, {"mesh", 0}});
  builder.add_node({{"name", "pen"}, {"mesh", 0}});
  EXPECT_TRUE(good(builder, "/nodes/0").bodies[0].tool);
  EXPECT_TRUE(good(builder, "/nodes/2").bodies[2].tool);
  builder.add_node({{"name", "/nodes/2"}, {"mesh", 0}});
  const GltfBodies named = good(builder, "/nodes/2");
  EXPECT_FALSE(named.bodies[2].tool);
  EXPECT_TRUE(named.bodies[3].tool);
}

TEST(Bodies, ShareAModelIfTheyShareMeshAndScale) {
  GltfBuilder builder = no_nodes();
  const double half = std::sqrt(0.5);
  const auto scaled = [&](Json scale) { builder.add_node({{"mesh", 0}, {"scale", std::move(scale)}}); };
  scaled({1, 1, 1});
  builder.add_node({{"mesh", 0}, {"rotation", {0, half, 0, half}}, {"translation", {5, 6, 7}}});
  scaled({1.0000001, 1, 1});  // as single precision rounds
  scaled({2, 2, 2});
  scaled({2, 2, 1});
  builder.add_node({{"mesh", 0}, {"scale", {2, 2, 1}}, {"rotation", {half, 0, 0, half}}});
  scaled({1, 1, -1});
  scaled({-1, 1, 1});
  const GltfBodies found = good(builder);
  std::vector<std::uint32_t> shapes;
  for (const GltfBody& body : found.bodies) shapes.push_back(body.shape);
  EXPECT_EQ(shapes, (std::vector<std::uint32_t>{0, 0, 0, 1, 2, 2, 3, 3}));
}

TEST(Bodies, MirroredNodesKeepTheirOutsideOutside) {
  GltfBuilder builder = no_nodes();
  builder.add_node({{"mesh", 0}, {"scale", {-2, 1, 1}}});
  const std::vector<DVec3> corners = corners_of(good(builder), good(builder).bodies[0]);
  ASSERT_EQ(corners.size(), 3u);
  const DVec3 area = 0.5 * glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  EXPECT_LT(glm::length(area - DVec3(0, 0, 1)), 1e-12) << "mirrored in x, the triangle still faces +z";
}

// A tree of nodes with turns, scales of both signs and, from the scales above turns, shear.
GltfBuilder random_tree(std::mt19937_64& generator) {
  GltfBuilder builder = no_nodes();
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto scale = [&] { return (generator() % 4 == 0 ? -1.0 : 1.0) * (1.5 + number(generator)); };
  for (int i = 0; i < 30; ++i) {
    Json node{{"translation", {number(generator), number(generator), number(generator)}},
              {"rotation", {number(generator), number(generator), number(generator), 1.1}},
              {"scale", {scale(), scale(), scale()}}};
    if (generator() % 4 != 0 || i == 0) node["mesh"] = 0;
    if (i == 0 || generator() % 3 == 0) {
      builder.add_node(node);
    } else {
      add_child(builder, static_cast<int>(generator() % static_cast<unsigned>(i)), node);
    }
  }
  return builder;
}

TEST(Bodies, LieWhereTheBakedSceneHasThem) {
  constexpr std::uint64_t kSeed = 5;
  RecordProperty("seed", std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  for (int round = 0; round < 20; ++round) {
    const GltfBuilder builder = random_tree(generator);
    const GltfBodies found = good(builder);
    const TriangleSoup baked = bake(read(builder).value());
    ASSERT_EQ(found.bodies.size(), baked.triangles.size()) << "one triangle a body";
    for (std::size_t i = 0; i < found.bodies.size(); ++i) {
      const std::vector<DVec3> corners = corners_of(found, found.bodies[i]);
      ASSERT_EQ(corners.size(), 3u);
      const DVec3 first = baked.positions[baked.triangles[i][0]];
      const double size = glm::length(baked.positions[baked.triangles[i][1]] - first) +
                          glm::length(baked.positions[baked.triangles[i][2]] - first);
      // Corners may be listed from another one on, not the other way round.
      double best = INFINITY;
      for (std::size_t turn = 0; turn < 3; ++turn) {
        double error = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
          error =
              std::max(error, glm::length(corners[(k + turn) % 3] - baked.positions[baked.triangles[i][k]]));
        best = std::min(best, error);
      }
      EXPECT_LT(best, 3e-6 * size) << "seed " << kSeed << " round " << round << " body " << i;
    }
  }
}

TEST(Bodies, HierarchyGivesTheNodesTransformsBack) {
  constexpr std::uint64_t kSeed = 6;
  RecordProperty("seed", std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  for (int round = 0; round < 20; ++round) {
    const GltfBuilder builder = random_tree(generator);
    const Result<GltfScene> scene = read(builder, with_hierarchy());
    ASSERT_TRUE(scene.ok());
    const GltfBodies found = good(builder);
    for (const GltfBody& body : found.bodies) {
      const auto node = std::ranges::find(scene.value().nodes, body.node, &GltfNode::index);
      DMat4 above(1.0);
      if (body.above >= 0) {
        const Pose pose = found.bodies[static_cast<std::size_t>(body.above)].scene_from_body;
        above = DMat4(pose.rotation);
        above[3] = glm::dvec4(pose.translation, 1.0);
      }
      const DMat4 parent = node->parent < 0
                               ? DMat4(1.0)
                               : scene.value().nodes[static_cast<std::size_t>(node->parent)].scene_from_node;
      const DMat4 rebuilt = above * body.above_from_parent;
      for (int i = 0; i < 16; ++i)
        EXPECT_NEAR(rebuilt[i / 4][i % 4], parent[i / 4][i % 4], 1e-9) << "seed " << kSeed;
    }
  }
}

TEST(Bodies, ToolHasAllThatIsBelowIt) {
  GltfBuilder builder = no_nodes();
  builder.add_node({{"name", "floor"}, {"mesh", 0}});
  const int hand = builder.add_node({{"name", "hand"}, {"translation", {1, 0, 0}}, {"scale", {2, 2, 2}}});
  const int palm = add_child(builder, hand, {{"name", "palm"}, {"mesh", 0}});
  add_child(builder, palm, {{"name", "finger"}, {"mesh", 0}, {"translation", {0, 0, 3}}});
  const GltfBodies found = good(builder, "hand");
  ASSERT_EQ(found.bodies.size(), 2u);
  EXPECT_FALSE(found.bodies[0].tool);
  EXPECT_TRUE(found.bodies[1].tool);
  EXPECT_EQ(found.bodies[1].name, "hand");
  const std::vector<DVec3> corners = corners_of(found, found.bodies[1]);
  ASSERT_EQ(corners.size(), 6u);
  EXPECT_LT(glm::length(corners[0] - DVec3(1, 0, 0)), 1e-6);
  EXPECT_LT(glm::length(corners[3] - DVec3(1, 0, 6)), 1e-6);
}

TEST(Bodies, ToolMustBeOneNodeWithTriangles) {
  GltfBuilder builder = no_nodes();
  builder.add_node({{"name", "twin"}, {"mesh", 0}});
  builder.add_node({{"name", "twin"}, {"mesh", 0}});
  builder.add_node({{"name", "empty"}});
  EXPECT_EQ(error_of(builder, "twin").code, ErrorCode::kInvalidArgument);
  EXPECT_NE(error_of(builder, "twin").message.find("nodes 0 and 1"), std::string::npos);
  EXPECT_EQ(error_of(builder, "nobody").code, ErrorCode::kInvalidArgument);
  EXPECT_NE(error_of(builder, "nobody").message.find("\"nobody\""), std::string::npos);
  EXPECT_EQ(error_of(builder, "empty").code, ErrorCode::kNoTriangles);
}

TEST(Bodies, NodesThatScaleToNothingAreLeftOut) {
  GltfBuilder builder = no_nodes();
  builder.add_node({{"name", "flat"}, {"mesh", 0}, {"scale", {1, 1, 0}}});  // the triangle lies in z = 0
  const int line = builder.add_node({{"name", "line"}, {"mesh", 0}, {"scale", {1, 0, 1}}});
  add_child(builder, line, {{"name", "below"}, {"mesh", 0}});
  builder.add_node({{"name", "point"}, {"mesh", 0}, {"scale", {0, 0, 0}}});
  const GltfBodies found = good(builder);
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_EQ(found.bodies[0].name, "flat");
  EXPECT_EQ(found.notes.size(), 3u);
  builder.json["scenes"][0]["nodes"] = {line};
  EXPECT_EQ(error_of(builder).code, ErrorCode::kNoTriangles);
  EXPECT_EQ(error_of(builder, "line").code, ErrorCode::kNoTriangles);
}

TEST(Bodies, InstancesOfANodeAreOneBody) {
  GltfBuilder builder = no_nodes();
  const int places = builder.add_positions({0, 0, 0, 0, 0, 1, 0, 0, 2});
  builder.add_node(
      {{"mesh", 0},
       {"translation", {10, 0, 0}},
       {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}}}});
  const GltfBodies found = good(builder);
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_EQ(found.shapes[0].triangles.size(), 3u);
  EXPECT_EQ(found.bodies[0].scene_from_body.translation, DVec3(10, 0, 0));
}

TEST(Bodies, FarAndCrushingPlacesAreErrors) {
  GltfBuilder builder = no_nodes();
  const int far = builder.add_node({{"mesh", 0}, {"scale", {1e200, 1e200, 1e200}}});
  add_child(builder, far, {{"mesh", 0}, {"scale", {1e200, 1, 1}}});
  EXPECT_EQ(error_of(builder).code, ErrorCode::kNonFinite);
  GltfBuilder unseen = no_nodes();  // also where no mesh is
  const int root = unseen.add_node({{"mesh", 0}});
  const int huge = add_child(unseen, root, {{"scale", {1e200, 1, 1}}});
  add_child(unseen, huge, {{"scale", {1e200, 1, 1}}});
  EXPECT_EQ(error_of(unseen).code, ErrorCode::kNonFinite);
}

TEST(Bodies, CyclesAndDepthAreErrors) {
  GltfBuilder cycle = no_nodes();
  const int root = cycle.add_node({{"mesh", 0}});
  const int below = add_child(cycle, root, {{"mesh", 0}});
  cycle.json["nodes"][static_cast<std::size_t>(below)]["children"] = {root};
  EXPECT_EQ(error_of(cycle).code, ErrorCode::kBadFormat);
  GltfBuilder deep = no_nodes();
  int last = deep.add_node({{"mesh", 0}});
  for (int i = 0; i < 1'000; ++i) last = add_child(deep, last, {{"mesh", 0}});
  EXPECT_EQ(error_of(deep).code, ErrorCode::kLimit);
}

// As many as a hostile file of a few hundred kilobytes has: no step may take the square of their number.
TEST(Bodies, ManyNodesOfOneMeshShareOneModel) {
  GltfBuilder builder = no_nodes();
  for (int i = 0; i < 20'000; ++i) {
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {i, 0, 0}}});
    builder.json["scenes"][0]["nodes"].push_back(i);
  }
  const GltfBodies found = good(builder);
  EXPECT_EQ(found.bodies.size(), 20'000u);
  EXPECT_EQ(found.shapes.size(), 1u);
}

}  // namespace
}  // namespace palpate::test
