#include <gtest/gtest.h>

#include <random>

#include "engine/gltf/gltf_bodies.h"
#include "tests/gltf/gltf_builder.h"

namespace palpate::test {
namespace {

constexpr const char* kPhysics = "KHR_physics_rigid_bodies";

Result<GltfBodies> bodies_of(const Bytes& bytes, const std::string& tool = {}) {
  GltfOptions options;
  options.hierarchy = true;
  options.limits.max_triangles = 10'000;
  const Result<GltfScene> scene = read(bytes, options);
  if (!scene) return scene.error();
  Result<GltfBodies> bodies = gather_bodies(scene.value(), tool, {});
  if (bodies) {
    for (const std::string& note : scene.value().notes) bodies.value().notes.push_back(note);
  }
  return bodies;
}

GltfBodies good(const GltfBuilder& builder, const std::string& tool = {}) {
  Result<GltfBodies> bodies = bodies_of(builder.glb(), tool);
  EXPECT_TRUE(bodies.ok()) << bodies.error().message;
  return bodies.ok() ? std::move(bodies.value()) : GltfBodies{};
}

HapticMaterial material_of(const GltfBuilder& builder) {
  const GltfBodies bodies = good(builder);
  return bodies.bodies.empty() ? HapticMaterial{} : bodies.bodies.front().material;
}

void expect_refused(const GltfBuilder& builder, const char* text) {
  const Result<GltfBodies> bodies = bodies_of(builder.glb());
  ASSERT_FALSE(bodies.ok()) << text;
  EXPECT_EQ(bodies.error().code, ErrorCode::kBadFormat);
  EXPECT_NE(bodies.error().message.find(text), std::string::npos) << bodies.error().message;
}

TEST(Haptics, AbsentWhereTheFileSaysNothing) {
  const HapticMaterial material = material_of(triangle_builder());
  EXPECT_FALSE(material.stiffness || material.damping || material.friction);
}

TEST(Haptics, NodeBeforeMeshBeforeMpegBeforePhysics) {
  GltfBuilder builder = triangle_builder();
  builder.json["nodes"][0]["extensions"][kPhysics]["collider"] = {{"physicsMaterial", 0}};
  builder.json["extensions"][kPhysics]["physicsMaterials"] = {{{"dynamicFriction", 0.4}}};
  EXPECT_EQ(material_of(builder).friction, 0.4);
  builder.json["meshes"][0]["extensions"]["MPEG_material_haptic"] = {{"hapticMaterialIndex", 0}};
  builder.json["extensions"]["MPEG_material_haptic"]["materials"] = {
      {{"extras", {{"friction", 0.3}, {"stiffness", 300}, {"damping", 3}}}}};
  EXPECT_EQ(material_of(builder).friction, 0.3);
  EXPECT_EQ(material_of(builder).damping, 3.0);
  builder.json["meshes"][0]["extras"] = {{"friction", 0.2}, {"stiffness", 200}};
  EXPECT_EQ(material_of(builder).friction, 0.2);
  EXPECT_EQ(material_of(builder).stiffness, 200.0);
  builder.json["nodes"][0]["extras"] = {{"friction", 0}};
  EXPECT_EQ(material_of(builder).friction, 0.0);
  EXPECT_EQ(material_of(builder).stiffness, 200.0);
  EXPECT_EQ(material_of(builder).damping, 3.0);
}

TEST(Haptics, ExtrasOfAnotherMeaningAreLeftOutWithANote) {
  GltfBuilder builder = triangle_builder();
  for (const Json& value : {Json("soft"), Json(-1), Json(1e16), Json(), Json::array({1})}) {
    builder.json["nodes"][0]["extras"] = {{"stiffness", value}, {"friction", 0.5}};
    const GltfBodies bodies = good(builder);
    EXPECT_FALSE(bodies.bodies[0].material.stiffness) << value;
    EXPECT_EQ(bodies.bodies[0].material.friction, 0.5);
    ASSERT_EQ(bodies.notes.size(), 1u);
    EXPECT_NE(bodies.notes[0].find("node 0 extras: \"stiffness\""), std::string::npos) << bodies.notes[0];
  }
  for (const Json& extras : {Json("text"), Json(1), Json::array({1, 2}), Json()}) {
    builder.json["nodes"][0]["extras"] = extras;
    EXPECT_TRUE(good(builder).notes.empty()) << extras;
  }
}

TEST(Haptics, MpegTexturesAreNoted) {
  GltfBuilder builder = triangle_builder();
  builder.json["meshes"][0]["extensions"]["MPEG_material_haptic"] = 0;  // as early files have it
  builder.json["extensions"]["MPEG_material_haptic"]["materials"] = {
      {{"stiffness", {{{"texture", {{"index", 0}}}, {"type", "High_Resolution"}}}}}};
  const GltfBodies bodies = good(builder);
  ASSERT_EQ(bodies.notes.size(), 1u);
  EXPECT_NE(bodies.notes[0].find("texture"), std::string::npos);
  EXPECT_FALSE(bodies.bodies[0].material.stiffness);
}

TEST(Haptics, PhysicsMaterialThatSaysNothingHasTheDefault) {
  GltfBuilder builder = triangle_builder();
  builder.json["extensionsRequired"] = {kPhysics, "KHR_implicit_shapes"};
  builder.json["nodes"][0]["extensions"][kPhysics]["collider"] = {{"physicsMaterial", 0}};
  builder.json["extensions"][kPhysics]["physicsMaterials"] = {Json::object()};
  EXPECT_EQ(material_of(builder).friction, 0.6);
}

TEST(Haptics, MotionsReachBelow) {
  GltfBuilder builder = triangle_builder();
  builder.json["nodes"][0]["extensions"][kPhysics]["motion"] = {{"mass", 2}};
  builder.json["nodes"].push_back({{"mesh", 0}});
  builder.json["nodes"][0]["children"] = {1};
  builder.add_node({{"mesh", 0}});
  const GltfBodies bodies = good(builder);
  ASSERT_EQ(bodies.bodies.size(), 3u);
  EXPECT_TRUE(bodies.bodies[0].moves);
  EXPECT_TRUE(bodies.bodies[1].moves);
  EXPECT_FALSE(bodies.bodies[2].moves);
}

TEST(Haptics, TriggersAreNotTouched) {
  GltfBuilder builder = triangle_builder();
  builder.json["nodes"][0]["extensions"][kPhysics]["trigger"] = {{"geometry", {{"node", 0}}}};
  EXPECT_FALSE(good(builder).bodies[0].touches_tool);
  builder.json["nodes"][0]["extensions"][kPhysics]["collider"] = Json::object();
  EXPECT_TRUE(good(builder).bodies[0].touches_tool);
}

// Two nodes with these filters, of which the first is the tool.
bool touch(const Json& tool, const Json& body) {
  GltfBuilder builder = triangle_builder();
  builder.json["extensions"][kPhysics]["collisionFilters"] = {tool, body};
  builder.json["nodes"][0]["name"] = "tool";
  builder.json["nodes"][0]["extensions"][kPhysics]["collider"] = {{"collisionFilter", 0}};
  builder.add_node({{"mesh", 0}, {"extensions", {{kPhysics, {{"collider", {{"collisionFilter", 1}}}}}}}});
  const GltfBodies bodies = good(builder, "tool");
  EXPECT_EQ(bodies.bodies.size(), 2u);
  return bodies.bodies.back().touches_tool;
}

TEST(Haptics, FiltersSayWhatTheToolNeverTouches) {
  const auto in = [](Json systems) { return Json{{"collisionSystems", std::move(systems)}}; };
  const Json any = Json::object();
  EXPECT_TRUE(touch(any, any));
  EXPECT_TRUE(touch(in({"hand"}), in({"wall"})));
  const Json only_walls = {{"collisionSystems", {"hand"}}, {"collideWithSystems", {"wall", "floor"}}};
  EXPECT_TRUE(touch(only_walls, in({"wall"})));
  EXPECT_TRUE(touch(only_walls, in({"floor", "wall"})));
  EXPECT_FALSE(touch(only_walls, in({"glass"})));
  EXPECT_FALSE(touch(only_walls, in({"glass", "wall"})));
  EXPECT_TRUE(touch(only_walls, any)) << "of a body in no system the filter says nothing";
  const Json no_glass = {{"collisionSystems", {"hand"}}, {"notCollideWithSystems", {"glass"}}};
  EXPECT_FALSE(touch(no_glass, in({"glass"})));
  EXPECT_TRUE(touch(no_glass, in({"glass", "wall"})));
  EXPECT_TRUE(touch(no_glass, in({"wall"})));
  EXPECT_FALSE(touch(in({"glass"}), no_glass)) << "each side may refuse";
  EXPECT_FALSE(touch(in({"glass"}), only_walls));
}

TEST(Haptics, BrokenExtensionsAreRefused) {
  const auto with = [](const Json& physics, const Json& collider) {
    GltfBuilder builder = triangle_builder();
    builder.json["extensions"][kPhysics] = physics;
    builder.json["nodes"][0]["extensions"][kPhysics]["collider"] = collider;
    return builder;
  };
  expect_refused(with(Json::object(), {{"physicsMaterial", 0}}), "node 0: physicsMaterial 0 does not exist");
  expect_refused(with(Json::object(), {{"collisionFilter", 3}}), "collisionFilter 3 does not exist");
  expect_refused(with(Json::object(), {{"physicsMaterial", -1}}), "physicsMaterial");
  expect_refused(with({{"physicsMaterials", {{{"dynamicFriction", -1}}}}}, Json::object()),
                 "physics material 0: \"dynamicFriction\"");
  expect_refused(with({{"collisionFilters", {{{"collisionSystems", {1}}}}}}, Json::object()),
                 "collision filter 0: \"collisionSystems\"");
  expect_refused(with({{"collisionFilters", 7}}, Json::object()), "collisionFilters");
  GltfBuilder mpeg = triangle_builder();
  mpeg.json["meshes"][0]["extensions"]["MPEG_material_haptic"] = {{"hapticMaterialIndex", 0}};
  expect_refused(mpeg, "hapticMaterialIndex 0 does not exist");
}

// All places of a document, so that one of them can be replaced.
void collect(Json& json, std::vector<Json*>& places) {
  places.push_back(&json);
  if (!json.is_structured()) return;
  for (Json& part : json) collect(part, places);
}

TEST(Haptics, MutatedDocumentsAreRefusedOrSound) {
  constexpr std::uint64_t kSeed = 31;
  RecordProperty("seed", std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  GltfBuilder whole = triangle_builder();
  whole.json["extensions"][kPhysics] = {
      {"physicsMaterials", {{{"dynamicFriction", 0.4}}}},
      {"collisionFilters", {{{"collisionSystems", {"a"}}, {"collideWithSystems", {"b"}}}}}};
  whole.json["extensions"]["MPEG_material_haptic"]["materials"] = {{{"extras", {{"friction", 0.3}}}}};
  whole.json["meshes"][0]["extensions"]["MPEG_material_haptic"] = {{"hapticMaterialIndex", 0}};
  whole.json["nodes"][0].update(
      {{"name", "tool"}, {"scale", {1, 2, 3}}, {"extras", {{"stiffness", 3}}}, {"children", {1}}});
  whole.json["nodes"][0]["extensions"][kPhysics] = {
      {"collider", {{"collisionFilter", 0}, {"physicsMaterial", 0}}}, {"motion", Json::object()}};
  whole.json["nodes"].push_back({{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}}});
  const std::vector<Json> values = {Json(),       Json(-1),       Json(0),           Json(1),
                                    Json(1e308),  Json(99999999), Json("tool"),      Json(""),
                                    Json(true),   Json::array(),  Json::object(),    Json(-0.0),
                                    Json({1, 0}), Json({"a"}),    Json({{"a", "b"}})};
  int sound = 0;
  for (int round = 0; round < 4'000; ++round) {
    GltfBuilder mutant = whole;
    for (std::uint64_t change = 0; change <= generator() % 3; ++change) {
      std::vector<Json*> places;
      collect(mutant.json, places);
      *places[generator() % places.size()] = values[generator() % values.size()];
    }
    const Result<GltfBodies> bodies = bodies_of(mutant.glb(), generator() % 2 ? "tool" : "");
    if (!bodies) {
      EXPECT_FALSE(bodies.error().message.empty());
      continue;
    }
    ++sound;
    for (const GltfBody& body : bodies.value().bodies) {
      ASSERT_LT(body.shape, bodies.value().shapes.size());
      ASSERT_LT(body.above, static_cast<std::int32_t>(bodies.value().bodies.size()));
      ASSERT_NEAR(glm::determinant(body.scene_from_body.rotation), 1.0, 1e-9) << "round " << round;
    }
  }
  EXPECT_GT(sound, 200) << "mutants that load are part of the test";
}

}  // namespace
}  // namespace palpate::test
