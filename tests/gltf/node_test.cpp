#include <gtest/gtest.h>

#include "tests/gltf/gltf_builder.h"
#include "tests/gltf/welded_scene.h"

namespace palpate::test {
namespace {

ErrorCode code_of(const Result<GltfScene>& result) {
  EXPECT_FALSE(result.ok());
  return result.ok() ? ErrorCode::kInternal : result.error().code;
}

// The triangle shown by a node with these properties.
GltfBuilder placed(const Json& properties) {
  GltfBuilder builder = triangle_builder();
  builder.json["nodes"][0].update(properties);
  return builder;
}

TriangleSoup baked(const GltfBuilder& builder) {
  const Result<GltfScene> scene = read(builder);
  EXPECT_TRUE(scene.ok()) << scene.error().message;
  return scene.ok() ? bake(scene.value()) : TriangleSoup{};
}

void expect_near(const DVec3& actual, const DVec3& expected) {
  EXPECT_LT(glm::length(actual - expected), 1e-12) << actual.x << ' ' << actual.y << ' ' << actual.z;
}

TEST(Node, ScalesThenRotatesThenMoves) {
  const double half = std::sqrt(0.5);
  const TriangleSoup soup =
      baked(placed({{"translation", {10, 20, 30}}, {"rotation", {0, 0, half, half}}, {"scale", {2, 3, 4}}}));
  expect_near(soup.positions[0], {10, 20, 30});
  expect_near(soup.positions[1], {10, 22, 30});
  expect_near(soup.positions[2], {7, 20, 30});
}

TEST(Node, MatrixIsColumnMajor) {
  const TriangleSoup soup = baked(placed({{"matrix", {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 10, 20, 30, 1}}}));
  EXPECT_EQ(soup.positions[1], DVec3(10, 22, 30));
  EXPECT_EQ(soup.positions[2], DVec3(7, 20, 30));
}

TEST(Node, MirroredWindingIsTurned) {
  // Mirrored in x the triangle still faces +z: its corners change place, its outside does not.
  const TriangleSoup soup = baked(placed({{"scale", {-1, 1, 1}}}));
  EXPECT_EQ(area_vector(soup), DVec3(0, 0, 0.5));
  EXPECT_EQ(area_vector(baked(placed({{"scale", {-1, -1, 1}}}))), DVec3(0, 0, 0.5));
  EXPECT_EQ(area_vector(baked(placed({{"scale", {-2, 3, 1}}}))), DVec3(0, 0, 3.0));
}

TEST(Node, TransformsNestInDoublePrecision) {
  GltfBuilder builder = placed({{"translation", {-1e9, 0, 0}}});
  builder.json["nodes"].push_back({{"children", {0}}, {"translation", {1e9 + 0.25, 0, 0}}});
  builder.json["scenes"][0]["nodes"] = {1};
  EXPECT_EQ(baked(builder).positions[0], DVec3(0.25, 0, 0));
}

TEST(Node, SharedMeshIsOneSoup) {
  GltfBuilder builder = triangle_builder();
  builder.add_node({{"mesh", 0}, {"name", "second"}, {"translation", {0, 0, 5}}});
  const Result<GltfScene> scene = read(builder);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene.value().meshes.size(), 1u);
  ASSERT_EQ(scene.value().instances.size(), 2u);
  EXPECT_EQ(scene.value().instances[1].name, "second");
  EXPECT_EQ(scene.value().instances[1].node, 1u);
  EXPECT_EQ(bake(scene.value()).positions[3], DVec3(0, 0, 5));
}

TEST(Node, CyclesAndSharedChildrenAreRefused) {
  GltfBuilder self = placed({{"children", {0}}});
  EXPECT_EQ(code_of(read(self)), ErrorCode::kBadFormat);
  GltfBuilder loop = placed({{"children", {1}}});
  loop.json["nodes"].push_back({{"children", {0}}});
  EXPECT_EQ(code_of(read(loop)), ErrorCode::kBadFormat);
  GltfBuilder shared = triangle_builder();
  shared.add_node({{"children", {0}}});
  shared.add_node({{"children", {0}}});
  const Result<GltfScene> scene = read(shared);
  EXPECT_EQ(code_of(scene), ErrorCode::kBadFormat);
  EXPECT_NE(scene.error().message.find("node 0 has two parents, 1 and 2"), std::string::npos);
  EXPECT_EQ(code_of(read(placed({{"children", {7}}}))), ErrorCode::kBadFormat);
  GltfBuilder twice = triangle_builder();
  twice.json["scenes"][0]["nodes"] = {0, 0};
  EXPECT_EQ(code_of(read(twice)), ErrorCode::kBadFormat);
}

TEST(Node, WrongTransformsAreRefused) {
  EXPECT_EQ(code_of(read(placed({{"rotation", {0, 0, 0, 0}}}))), ErrorCode::kBadFormat);
  EXPECT_EQ(code_of(read(placed({{"scale", {1, 1}}}))), ErrorCode::kBadFormat);
  EXPECT_EQ(code_of(read(placed({{"matrix", {1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}))),
            ErrorCode::kBadFormat);
  GltfBuilder huge = placed({{"scale", {1e300, 1, 1}}});
  huge.json["nodes"].push_back({{"children", {0}}, {"scale", {1e300, 1, 1}}});
  huge.json["scenes"][0]["nodes"] = {1};
  EXPECT_EQ(code_of(read(huge)), ErrorCode::kNonFinite);
}

// Scene 0 has one triangle, scene 1 two.
GltfBuilder two_scenes() {
  GltfBuilder builder = triangle_builder();
  builder.json["nodes"].push_back({{"mesh", 0}});
  builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {1, 0, 0}}});
  builder.json["scenes"].push_back({{"nodes", {1, 2}}});
  return builder;
}

TEST(Scene, IsTheDefaultOrTheOneAskedFor) {
  GltfBuilder builder = two_scenes();
  EXPECT_EQ(baked(builder).triangles.size(), 1u);
  builder.json["scene"] = 1;
  EXPECT_EQ(baked(builder).triangles.size(), 2u);
  GltfOptions options;
  options.scene = 0;
  EXPECT_EQ(bake(read(builder, options).value()).triangles.size(), 1u);
  options.scene = 2;
  EXPECT_EQ(code_of(read(builder, options)), ErrorCode::kInvalidArgument);
  options.scene = -2;
  EXPECT_EQ(code_of(read(builder, options)), ErrorCode::kInvalidArgument);
  builder.json["scene"] = 2;
  EXPECT_EQ(code_of(read(builder)), ErrorCode::kBadFormat);
}

TEST(Scene, WithoutAnyAllRootsAreRead) {
  GltfBuilder builder = two_scenes();
  builder.json.erase("scenes");
  builder.json.erase("scene");
  builder.json["nodes"][0]["children"] = {1};
  const Result<GltfScene> scene = read(builder);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene.value().instances.size(), 3u);
  EXPECT_EQ(scene.value().notes.size(), 1u);
  builder.json["scene"] = 0;
  EXPECT_EQ(code_of(read(builder)), ErrorCode::kBadFormat) << "a default scene that is none of none";
  builder.json.erase("scene");
  builder.json.erase("nodes");
  EXPECT_EQ(code_of(read(builder)), ErrorCode::kNoTriangles);
}

TEST(Scene, EmptyOneHasNoTriangles) {
  GltfBuilder builder = triangle_builder();
  builder.json["scenes"][0]["nodes"] = Json::array();
  EXPECT_EQ(code_of(read(builder)), ErrorCode::kNoTriangles);
}

GltfBuilder instanced() {
  GltfBuilder builder = placed({{"translation", {0, 0, 100}}});
  const int translations = builder.add_positions({1, 0, 0, 2, 0, 0});
  const int rotations =
      builder.add_array(std::vector<std::int8_t>{0, 0, 0, 127, 0, 0, 127, 0}, 5120, "VEC4", 4);
  builder.json["accessors"][rotations]["normalized"] = true;
  const int scales = builder.add_positions({1, 1, 1, 1, 1, -3});
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", translations}, {"ROTATION", rotations}, {"SCALE", scales}, {"_COLOR", 99}};
  return builder;
}

TEST(GpuInstancing, RepeatsTheMesh) {
  const Result<GltfScene> scene = read(instanced());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene.value().instances.size(), 2u);
  const TriangleSoup soup = bake(scene.value());
  ASSERT_EQ(soup.triangles.size(), 2u);
  expect_near(soup.positions[1], {2, 0, 100});
  expect_near(soup.positions[4], {1, 0, 100});
  expect_near(soup.positions[5], {2, -1, 100});
  expect_near(area_vector(soup), {0, 0, 0});  // the second is mirrored in z, so that it faces −z
}

TEST(GpuInstancing, UnequalCountsAreRefused) {
  GltfBuilder builder = instanced();
  builder.json["accessors"][1]["count"] = 1;
  EXPECT_EQ(code_of(read(builder)), ErrorCode::kBadFormat);
}

}  // namespace
}  // namespace palpate::test
