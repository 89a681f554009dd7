#include <gtest/gtest.h>

#include <cmath>

#include "tests/gltf/gltf_builder.h"

namespace palpate::test {
namespace {

TriangleSoup baked(const Result<GltfScene>& scene) {
  EXPECT_TRUE(scene.ok()) << scene.error().message;
  return scene.ok() ? bake(scene.value()) : TriangleSoup{};
}

// The triangle with two targets: all up by one, first corner along x by ten.
GltfBuilder morphed() {
  GltfBuilder builder = triangle_builder();
  const int up = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1});
  const int along = builder.add_positions({10, 0, 0, 0, 0, 0, 0, 0, 0});
  builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", up}},
                                                           {{"POSITION", along}, {"NORMAL", 77}}};
  return builder;
}

TEST(Morph, RestsAtTheMeshWeightsUnlessTheNodeHasItsOwn) {
  GltfBuilder builder = morphed();
  EXPECT_EQ(baked(read(builder)).positions[0], DVec3(0, 0, 0));
  builder.json["meshes"][0]["weights"] = {0.5, 0.25};
  EXPECT_EQ(baked(read(builder)).positions[0], DVec3(2.5, 0, 0.5));
  EXPECT_EQ(baked(read(builder)).positions[1], DVec3(1, 0, 0.5));
  builder.json["nodes"][0]["weights"] = {0, 1};
  EXPECT_EQ(baked(read(builder)).positions[0], DVec3(10, 0, 0));
}

TEST(Morph, NodesOfDifferentWeightsHaveSoupsOfTheirOwn) {
  GltfBuilder builder = morphed();
  builder.add_node({{"mesh", 0}, {"weights", {1, 0}}});
  builder.add_node({{"mesh", 0}, {"weights", {0, 0}}});  // the same as none
  const Result<GltfScene> scene = read(builder);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene.value().meshes.size(), 2u);
  ASSERT_EQ(scene.value().instances.size(), 3u);
  EXPECT_EQ(scene.value().instances[0].mesh, scene.value().instances[2].mesh);
}

TEST(Morph, TargetsOfAnotherLengthAreRefused) {
  GltfBuilder builder = morphed();
  builder.json["meshes"][0]["weights"] = {1};
  builder.json["accessors"][1]["count"] = 2;
  const Result<GltfScene> scene = read(builder);
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, ErrorCode::kBadFormat);
  EXPECT_NE(scene.error().message.find("morph target 0"), std::string::npos) << scene.error().message;
}

// The triangle bound to joint 1 (a quarter turn about z, moved along x by ten) with its first corner, to
// joint 2 (at rest) with its second, and half to each with its third. Joint 1 was bound five along x.
GltfBuilder skinned() {
  GltfBuilder builder = triangle_builder();
  const int joints =
      builder.add_array(std::vector<std::uint8_t>{0, 9, 9, 9, 1, 0, 0, 0, 0, 1, 0, 0}, 5121, "VEC4", 4);
  const int weights = builder.add_array(std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0, 0, 0, 127, 127, 0, 0},
                                        5121, "VEC4", 4);
  builder.json["accessors"][weights]["normalized"] = true;
  const int inverse_bind =
      builder.add_array(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, 0, 0, 1,  //
                                           1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1},
                        5126, "MAT4", 16);
  Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = joints;
  attributes["WEIGHTS_0"] = weights;
  builder.json["nodes"][0].update({{"skin", 0}, {"translation", {1000, 0, 0}}});  // which must not matter
  const double half = std::sqrt(0.5);
  builder.add_node({{"translation", {10, 0, 0}}, {"rotation", {0, 0, half, half}}});
  builder.add_node(Json::object());
  builder.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse_bind}}};
  return builder;
}

void expect_near(const DVec3& actual, const DVec3& expected) {
  EXPECT_LT(glm::length(actual - expected), 1e-12) << actual.x << ' ' << actual.y << ' ' << actual.z;
}

TEST(Skin, IsPlacedByItsJointsAlone) {
  const TriangleSoup soup = baked(read(skinned()));
  ASSERT_EQ(soup.positions.size(), 3u);
  expect_near(soup.positions[0], {10, -5, 0});
  expect_near(soup.positions[1], {1, 0, 0});
  expect_near(soup.positions[2], {4.5, -2, 0});  // between (9, −5, 0) and (0, 1, 0)
}

TEST(Skin, WithoutBindMatricesJointsMoveTheMesh) {
  GltfBuilder builder = skinned();
  builder.json["skins"][0].erase("inverseBindMatrices");
  expect_near(baked(read(builder)).positions[0], {10, 0, 0});
}

TEST(Skin, MirroredJointsTurnTheWinding) {
  GltfBuilder builder = skinned();
  builder.json["skins"][0].erase("inverseBindMatrices");
  builder.json["skins"][0]["joints"] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  builder.json["nodes"][1] = {{"scale", {-1, 1, 1}}};
  expect_near(area_vector(baked(read(builder))), {0, 0, 0.5});
}

TEST(Skin, WrongOnesAreRefused) {
  struct Case {
    const char* pointer;
    Json value;
    const char* text;
  };
  const Case cases[] = {{"/nodes/0/skin", 1, "skin 1 does not exist"},
                        {"/skins/0/joints", Json::array({1}), "joint 1 is past the last joint 0"},
                        {"/skins/0/joints", Json::array({1, 9}), "node 9 does not exist"},
                        {"/skins/0/joints", Json::array({1, 2, 2}), "2 inverse bind matrices for 3 joints"},
                        {"/skins/0/joints", Json::array(), "no joints"},
                        {"/accessors/1/count", 2, "JOINTS_0"},
                        {"/meshes/0/primitives/0/attributes", {{"POSITION", 0}}, "no JOINTS_0"}};
  for (const Case& wrong : cases) {
    GltfBuilder builder = skinned();
    builder.json[Json::json_pointer(wrong.pointer)] = wrong.value;
    const Result<GltfScene> scene = read(builder);
    ASSERT_FALSE(scene.ok()) << wrong.text;
    EXPECT_EQ(scene.error().code, ErrorCode::kBadFormat) << scene.error().message;
    EXPECT_NE(scene.error().message.find(wrong.text), std::string::npos) << scene.error().message;
  }
}

}  // namespace
}  // namespace palpate::test
