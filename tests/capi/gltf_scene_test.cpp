#include <chrono>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <random>
#include <thread>

#include "tests/capi/gltf_file.h"

namespace palpate::test {
namespace {

plp_gltf_scene_options options_with_tool(const char* tool) {
  plp_gltf_scene_options options;
  plp_gltf_scene_options_init(&options, sizeof options);
  options.tool = tool;
  return options;
}

std::vector<plp_body> list(plp_scene scene) {
  std::size_t count = 0;
  EXPECT_EQ(plp_scene_list_bodies(scene, nullptr, 0, &count), PLP_OK);
  std::vector<plp_body> bodies(count);
  EXPECT_EQ(plp_scene_list_bodies(scene, bodies.data(), bodies.size(), &count), PLP_OK);
  return bodies;
}

plp_body_info info_of(plp_scene scene, plp_body body) {
  plp_body_info info;
  plp_body_info_init(&info, sizeof info);
  EXPECT_EQ(plp_scene_get_body_info(scene, body, &info), PLP_OK) << plp_last_error();
  return info;
}

plp_body find(plp_scene scene, const char* name) {
  plp_body body = 0;
  EXPECT_EQ(plp_scene_find_body(scene, name, &body), PLP_OK) << plp_last_error();
  return body;
}

plp_pose pose_of(plp_scene scene, plp_body body) {
  plp_pose pose{};
  EXPECT_EQ(plp_scene_get_pose(scene, body, &pose), PLP_OK) << plp_last_error();
  return pose;
}

glm::dmat4 node_matrix(plp_scene scene, plp_body body) {
  glm::dmat4 matrix(0.0);
  EXPECT_EQ(plp_scene_get_node_matrix(scene, body, &matrix[0][0]), PLP_OK) << plp_last_error();
  return matrix;
}

glm::dmat4 matrix_of(const plp_pose& pose) {
  const double* q = pose.orientation;
  glm::dmat4 matrix = glm::mat4_cast(glm::dquat(q[3], q[0], q[1], q[2]));
  for (int i = 0; i < 3; ++i) matrix[3][i] = pose.position[i];
  return matrix;
}

double difference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0.0;
  for (int i = 0; i < 16; ++i) largest = std::max(largest, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
  return largest;
}

// A table, a cup on it that moves and feels soft, and a pen above; all boxes.
Json kitchen() {
  Json json = gltf_of({box(0.5f, 0.5f, 0.5f)});
  add_node(json, {{"name", "table"}, {"mesh", 0}, {"scale", {4, 0.2, 4}}});
  add_node(json, {{"name", "cup"},
                  {"mesh", 0},
                  {"translation", {0, 0.6, 0}},
                  {"extras", {{"stiffness", 200}, {"damping", 2}, {"friction", 0}}},
                  {"extensions", {{"KHR_physics_rigid_bodies", {{"motion", Json::object()}}}}}});
  add_node(json, {{"name", "pen"}, {"mesh", 0}, {"translation", {0, 1.65, 0}}, {"scale", {0.1, 1, 0.1}}});
  return json;
}

TEST(GltfScene, NodesBecomeBodies) {
  const GltfFile file(kitchen());
  TestScene scene(0.001);
  plp_gltf_scene_options options = options_with_tool("pen");
  options.cutoff = 0.1;
  plp_body bodies[2] = {};
  std::size_t count = 0;
  ASSERT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), &options, bodies, 2, &count), PLP_OK)
      << plp_last_error();
  EXPECT_EQ(count, 3u) << "more than there was room for";
  EXPECT_EQ(list(scene.handle).size(), 3u);
  EXPECT_EQ(bodies[0], find(scene.handle, "table"));
  EXPECT_EQ(bodies[1], find(scene.handle, "cup"));

  const plp_body_info cup = info_of(scene.handle, bodies[1]);
  EXPECT_STREQ(cup.name, "cup");
  EXPECT_EQ(cup.kind, PLP_BODY_MOVING);
  EXPECT_EQ(cup.node, 1);
  EXPECT_EQ(cup.triangles, 12u);
  EXPECT_EQ(cup.above, 0u);
  EXPECT_EQ(cup.stiffness, 200.0);
  EXPECT_EQ(cup.damping, 2.0);
  EXPECT_EQ(cup.friction, -1.0);
  EXPECT_EQ(info_of(scene.handle, bodies[0]).kind, PLP_BODY_STATIC);
  EXPECT_EQ(info_of(scene.handle, find(scene.handle, "pen")).kind, PLP_BODY_TOOL);

  // The pen's flat end is 0.05 m above the cup's flat top, within the cutoff that came with the file.
  const plp_contacts contacts = scene.step();
  ASSERT_EQ(contacts.set_count, 1u);
  EXPECT_NEAR(contacts.min_distance, 0.05, 1e-6);
  EXPECT_NEAR(contacts.wrench.force[1], 200.0 * 0.05, 1e-3);
}

// The same boxes told to a scene one by one.
TEST(GltfScene, FeelsAsBodiesAddedByHandDo) {
  const GltfFile file(kitchen());
  TestScene loaded(0.1);
  const plp_gltf_scene_options options = options_with_tool("pen");
  ASSERT_EQ(plp_scene_load_gltf(loaded.handle, file.path().c_str(), &options, nullptr, 0, nullptr), PLP_OK)
      << plp_last_error();
  TestScene made(0.1);
  const TestModel table(box(2.0f, 0.1f, 2.0f));
  const TestModel cup(box(0.5f, 0.5f, 0.5f));
  const TestModel pen(box(0.05f, 0.5f, 0.05f));
  made.add(table.handle, PLP_BODY_STATIC, at(0, 0, 0));
  plp_body_options soft;
  plp_body_options_init(&soft, sizeof soft);
  soft.model = cup.handle;
  soft.pose = at(0, 0.6, 0);
  soft.stiffness = 200.0;
  soft.damping = 2.0;
  soft.friction = -1.0;
  plp_body body = 0;
  ASSERT_EQ(plp_scene_add_body(made.handle, &soft, &body), PLP_OK);
  const plp_body tool = made.add(pen.handle, PLP_BODY_TOOL, at(0, 1.65, 0));
  const plp_body loaded_tool = find(loaded.handle, "pen");
  for (int i = 0; i < 40; ++i) {  // over the cup's edge and down beside it
    const double turn = 0.1 * i;
    const plp_pose pose = {{0.02 * i, 1.65 - 0.001 * i, 0.005 * i},
                           {std::sin(turn / 2), 0.0, 0.0, std::cos(turn / 2)}};
    ASSERT_EQ(plp_scene_set_pose(made.handle, tool, &pose), PLP_OK);
    ASSERT_EQ(plp_scene_set_pose(loaded.handle, loaded_tool, &pose), PLP_OK);
    const plp_contacts theirs = made.step();
    const plp_contacts ours = loaded.step();
    ASSERT_EQ(ours.set_count, theirs.set_count) << i;
    EXPECT_EQ(ours.overlap, theirs.overlap) << i;
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(ours.wrench.force[k], theirs.wrench.force[k], 1e-3) << i;
      EXPECT_NEAR(ours.wrench.torque[k], theirs.wrench.torque[k], 1e-3) << i;
    }
  }
}

TEST(GltfScene, SharedMeshesAreOneModel) {
  Json json = gltf_of({box(0.5f, 0.5f, 0.5f)});
  add_node(json, {{"name", "one"}, {"mesh", 0}});
  add_node(json, {{"name", "two"}, {"mesh", 0}, {"translation", {3, 0, 0}}});
  add_node(json, {{"name", "large"}, {"mesh", 0}, {"scale", {2, 2, 2}}});
  const GltfFile file(json);
  TestScene scene(0.1);
  ASSERT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), nullptr, nullptr, 0, nullptr), PLP_OK);
  const auto tree_bytes = [&](const char* name, bool prepare) {
    plp_model model = nullptr;
    EXPECT_EQ(plp_scene_get_body_model(scene.handle, find(scene.handle, name), &model), PLP_OK);
    if (prepare) {
      EXPECT_EQ(plp_model_prepare(model), PLP_OK);
    }
    plp_model_info info;
    plp_model_info_init(&info, sizeof info);
    EXPECT_EQ(plp_model_get_info(model, &info), PLP_OK);
    EXPECT_EQ(plp_model_release(model), PLP_OK);
    return info.tree_bytes;
  };
  EXPECT_EQ(tree_bytes("two", false), 0u);
  EXPECT_GT(tree_bytes("one", true), 0u);
  EXPECT_GT(tree_bytes("two", false), 0u) << "the hierarchy that was built for the other";
  EXPECT_EQ(tree_bytes("large", false), 0u);
}

// A document whose nodes are turned, scaled, mirrored, and sheared by what is above them.
Json random_tree(std::mt19937_64& generator) {
  Json json = gltf_of({box(0.5f, 0.3f, 0.2f)});
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto scale = [&] { return (generator() % 4 == 0 ? -1.0 : 1.0) * (1.5 + number(generator)); };
  for (unsigned i = 0; i < 20; ++i) {
    Json node = {{"name", "node " + std::to_string(i)},
                 {"translation", {number(generator), number(generator), number(generator)}},
                 {"rotation", {number(generator), number(generator), number(generator), 1.1}},
                 {"scale", {scale(), scale(), scale()}}};
    if (i == 0 || generator() % 3 != 0) node["mesh"] = 0;
    const bool root = i == 0 || generator() % 4 == 0;
    add_node(json, std::move(node), root ? -1 : static_cast<int>(generator() % i));
  }
  return json;
}

glm::dmat4 local_matrix(const Json& node) {
  if (node.contains("matrix")) {
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node["matrix"][static_cast<std::size_t>(i)];
    return matrix;
  }
  const Json& r = node["rotation"];
  glm::dmat4 matrix = glm::mat4_cast(glm::normalize(
      glm::dquat(r[3].get<double>(), r[0].get<double>(), r[1].get<double>(), r[2].get<double>())));
  for (int i = 0; i < 3; ++i) {
    matrix[i] *= node["scale"][static_cast<std::size_t>(i)].get<double>();
    matrix[3][i] = node["translation"][static_cast<std::size_t>(i)].get<double>();
  }
  return matrix;
}

TEST(GltfScene, NodeMatricesAreTheFilesWhileNothingMoves) {
  constexpr std::uint64_t kSeed = 7;
  RecordProperty("seed", std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  for (int round = 0; round < 10; ++round) {
    const Json json = random_tree(generator);
    const GltfFile file(json);
    plp_scene_options unity = TestScene::options_with(10.0);
    unity.space = {{-1, 2, 3}, 0, 0.01};
    TestScene scene(unity);
    ASSERT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), nullptr, nullptr, 0, nullptr), PLP_OK)
        << plp_last_error();
    for (const plp_body body : list(scene.handle)) {
      const auto node = static_cast<std::size_t>(info_of(scene.handle, body).node);
      EXPECT_LT(difference(node_matrix(scene.handle, body), local_matrix(json["nodes"][node])), 1e-9)
          << "seed " << kSeed << " round " << round << " node " << node;
    }
  }
}

// Bodies are moved at will; the file with the matrices written back must then load to where they are.
TEST(GltfScene, NodeMatricesWrittenBackPutTheBodiesWhereTheyAre) {
  constexpr std::uint64_t kSeed = 8;
  RecordProperty("seed", std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int round = 0; round < 10; ++round) {
    Json json = random_tree(generator);
    const GltfFile file(json);
    TestScene scene(0.1);
    ASSERT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), nullptr, nullptr, 0, nullptr), PLP_OK);
    for (const plp_body body : list(scene.handle)) {
      const plp_pose pose = {{number(generator), number(generator), number(generator)},
                             {number(generator), number(generator), number(generator), 1.1}};
      if (generator() % 2 == 0) {
        ASSERT_EQ(plp_scene_set_pose(scene.handle, body, &pose), PLP_OK);
      }
    }
    for (const plp_body body : list(scene.handle)) {
      Json& node = json["nodes"][static_cast<std::size_t>(info_of(scene.handle, body).node)];
      for (const char* key : {"translation", "rotation", "scale"}) node.erase(key);
      const glm::dmat4 matrix = node_matrix(scene.handle, body);
      node["matrix"] = std::vector<double>(&matrix[0][0], &matrix[0][0] + 16);
    }
    const GltfFile written(json);
    TestScene again(0.1);
    ASSERT_EQ(plp_scene_load_gltf(again.handle, written.path().c_str(), nullptr, nullptr, 0, nullptr), PLP_OK)
        << plp_last_error();
    const std::vector<plp_body> bodies = list(scene.handle);
    const std::vector<plp_body> reloaded = list(again.handle);
    ASSERT_EQ(bodies.size(), reloaded.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
      EXPECT_LT(difference(matrix_of(pose_of(scene.handle, bodies[i])),
                           matrix_of(pose_of(again.handle, reloaded[i]))),
                1e-8)
          << "seed " << kSeed << " round " << round << " body " << i;
  }
}

TEST(GltfScene, StandsWhereThePoseOfTheOptionsPutsIt) {
  const GltfFile file(kitchen());
  TestScene scene(0.1);
  plp_gltf_scene_options options = options_with_tool(nullptr);
  options.pose = {{10, 0, 0}, {0, std::sqrt(0.5), 0, std::sqrt(0.5)}};
  ASSERT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), &options, nullptr, 0, nullptr), PLP_OK);
  const plp_body cup = find(scene.handle, "cup");
  EXPECT_NEAR(pose_of(scene.handle, cup).position[0], 10.0, 1e-12);
  EXPECT_NEAR(pose_of(scene.handle, cup).position[1], 0.6, 1e-12);
  EXPECT_NEAR(node_matrix(scene.handle, cup)[3][0], 0.0, 1e-12) << "in the file it is where it was";
}

TEST(GltfScene, ScaleMakesTheWholeFileLargerAndNotItsMatrices) {
  constexpr std::uint64_t kSeed = 9;
  std::mt19937_64 generator(kSeed);
  const Json json = random_tree(generator);
  const GltfFile file(json);
  plp_model_options model;
  plp_model_options_init(&model, sizeof model);
  plp_gltf_scene_options options = options_with_tool(nullptr);
  options.model = &model;
  TestScene small(0.1);
  ASSERT_EQ(plp_scene_load_gltf(small.handle, file.path().c_str(), &options, nullptr, 0, nullptr), PLP_OK);
  model.scale = 4.0;
  TestScene large(0.1);
  ASSERT_EQ(plp_scene_load_gltf(large.handle, file.path().c_str(), &options, nullptr, 0, nullptr), PLP_OK);
  const std::vector<plp_body> ours = list(large.handle);
  const std::vector<plp_body> theirs = list(small.handle);
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const plp_pose pose = pose_of(large.handle, ours[i]);
    const plp_pose expected = pose_of(small.handle, theirs[i]);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(pose.position[k], 4.0 * expected.position[k], 1e-9) << kSeed;
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(pose.orientation[k], expected.orientation[k], 1e-9) << kSeed;
    EXPECT_LT(difference(node_matrix(large.handle, ours[i]), node_matrix(small.handle, theirs[i])), 1e-9);
  }
}

TEST(GltfScene, WhatIsIntangibleIsNotTouched) {
  Json json = kitchen();
  json["nodes"][1]["extensions"]["KHR_physics_rigid_bodies"]["trigger"] = {{"geometry", {{"node", 1}}}};
  const GltfFile file(json);
  TestScene scene(0.1);
  const plp_gltf_scene_options options = options_with_tool("pen");
  ASSERT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), &options, nullptr, 0, nullptr), PLP_OK);
  EXPECT_EQ(info_of(scene.handle, find(scene.handle, "cup")).intangible, 1);
  EXPECT_EQ(scene.step().set_count, 0u);
  const plp_pose inside = at(0, 0.65, 0);
  ASSERT_EQ(plp_scene_set_pose(scene.handle, find(scene.handle, "pen"), &inside), PLP_OK);
  const plp_contacts contacts = scene.step();
  EXPECT_EQ(contacts.overlap, 0);
  EXPECT_EQ(contacts.set_count, 1u) << "the table below is still there";
}

TEST(GltfScene, AnErrorLeavesTheSceneAsItWas) {
  const GltfFile good(kitchen());
  TestScene scene(0.001);
  const auto load = [&](const GltfFile& file, const plp_gltf_scene_options& options) {
    plp_body body = 77;
    std::size_t count = 77;
    const plp_result result =
        plp_scene_load_gltf(scene.handle, file.path().c_str(), &options, &body, 1, &count);
    EXPECT_TRUE(result == PLP_OK || (body == 77 && count == 77)) << "outputs are untouched";
    return result;
  };
  plp_gltf_scene_options options = options_with_tool("pen");
  options.cutoff = 0.1;
  ASSERT_EQ(load(good, options), PLP_OK);
  const auto expect_kept = [&] {
    EXPECT_EQ(list(scene.handle).size(), 3u) << plp_last_error();
    EXPECT_NEAR(scene.step().min_distance, 0.05, 1e-6);
  };
  options.cutoff = 3.0;
  EXPECT_EQ(load(good, options), PLP_ERROR_INVALID_ARGUMENT) << "a second tool";
  expect_kept();
  options.tool = "nobody";
  EXPECT_EQ(load(good, options), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(plp_last_error()).find("nobody"), std::string::npos);
  options.tool = "";
  EXPECT_EQ(load(good, options), PLP_ERROR_INVALID_ARGUMENT);
  options.tool = nullptr;
  for (const double cutoff : {-1.0, std::nan(""), 1e16}) {
    options.cutoff = cutoff;
    EXPECT_EQ(load(good, options), PLP_ERROR_INVALID_ARGUMENT);
  }
  options.cutoff = 3.0;
  options.flags = 1;
  EXPECT_EQ(load(good, options), PLP_ERROR_INVALID_ARGUMENT);
  options.flags = 0;
  options.pose.orientation[3] = 0.0;
  EXPECT_EQ(load(good, options), PLP_ERROR_INVALID_ARGUMENT);
  options.pose.orientation[3] = 1.0;
  plp_model_options few;
  plp_model_options_init(&few, sizeof few);
  few.max_triangles = 30;  // twelve for each of three nodes
  options.model = &few;
  EXPECT_EQ(load(good, options), PLP_ERROR_LIMIT);
  options.model = nullptr;
  expect_kept();

  Json broken = kitchen();
  broken["nodes"][2]["matrix"] = Json::array({1, 2, 3});
  EXPECT_EQ(load(GltfFile(broken), options), PLP_ERROR_BAD_FORMAT);
  broken = kitchen();
  broken["nodes"][2]["children"] = {0};
  broken["nodes"][0]["children"] = {2};
  EXPECT_EQ(load(GltfFile(broken), options), PLP_ERROR_BAD_FORMAT) << "a cycle";
  broken = kitchen();
  broken["nodes"][2]["translation"] = {1e16, 0, 0};
  EXPECT_EQ(load(GltfFile(broken), options), PLP_ERROR_LIMIT) << "farther than any pose";
  broken = kitchen();
  broken["nodes"][2]["scale"] = {1e300, 1e300, 1e300};
  broken["nodes"][2]["children"] = {3};
  broken["nodes"].push_back({{"mesh", 0}, {"scale", {1e300, 1, 1}}});
  EXPECT_EQ(load(GltfFile(broken), options), PLP_ERROR_NON_FINITE);
  EXPECT_EQ(plp_scene_load_gltf(scene.handle, "/nowhere.gltf", nullptr, nullptr, 0, nullptr),
            PLP_ERROR_FILE_NOT_FOUND);
  expect_kept();
}

TEST(GltfScene, BadArgumentsAreRefused) {
  const GltfFile file(kitchen());
  TestScene scene(0.1);
  plp_body body = 0;
  std::size_t count = 0;
  EXPECT_EQ(plp_scene_load_gltf(nullptr, file.path().c_str(), nullptr, nullptr, 0, nullptr),
            PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_load_gltf(scene.handle, nullptr, nullptr, nullptr, 0, nullptr),
            PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), nullptr, nullptr, 1, nullptr),
            PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_list_bodies(scene.handle, nullptr, 1, &count), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_list_bodies(scene.handle, &body, 1, nullptr), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_find_body(scene.handle, "", &body), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_find_body(scene.handle, nullptr, &body), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_scene_find_body(scene.handle, "pen", &body), PLP_ERROR_INVALID_ARGUMENT);
  plp_body_info info;
  plp_body_info_init(&info, sizeof info);
  EXPECT_EQ(plp_scene_get_body_info(scene.handle, 5, &info), PLP_ERROR_INVALID_HANDLE);
  plp_model model = nullptr;
  EXPECT_EQ(plp_scene_get_body_model(scene.handle, 5, &model), PLP_ERROR_INVALID_HANDLE);
  double matrix[16];
  EXPECT_EQ(plp_scene_get_node_matrix(scene.handle, 5, matrix), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_get_node_matrix(scene.handle, 5, nullptr), PLP_ERROR_INVALID_ARGUMENT);
  const TestModel cube(box(1, 1, 1));
  body = scene.add(cube.handle, PLP_BODY_STATIC, at(0, 0, 0));
  EXPECT_EQ(plp_scene_get_node_matrix(scene.handle, body, matrix), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(info_of(scene.handle, body).node, -1);
  EXPECT_STREQ(info_of(scene.handle, body).name, "");
  plp_body_options options;
  plp_body_options_init(&options, sizeof options);
  options.model = cube.handle;
  options.intangible = 2;
  EXPECT_EQ(plp_scene_add_body(scene.handle, &options, &body), PLP_ERROR_INVALID_ARGUMENT);
  options.intangible = 1;
  options.kind = PLP_BODY_TOOL;
  EXPECT_EQ(plp_scene_add_body(scene.handle, &options, &body), PLP_ERROR_INVALID_ARGUMENT);
}

TEST(GltfScene, RemovedBodiesAreNotFoundAndLeaveThoseBelowWithoutAMatrix) {
  Json json = gltf_of({box(0.5f, 0.5f, 0.5f)});
  const std::size_t base = add_node(json, {{"name", "base"}, {"mesh", 0}});
  add_node(json, {{"name", "arm"}, {"mesh", 0}, {"translation", {0, 2, 0}}}, static_cast<int>(base));
  const GltfFile file(json);
  TestScene scene(0.1);
  ASSERT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), nullptr, nullptr, 0, nullptr), PLP_OK);
  const plp_body arm = find(scene.handle, "arm");
  EXPECT_EQ(info_of(scene.handle, arm).above, find(scene.handle, "base"));
  ASSERT_EQ(plp_scene_remove_body(scene.handle, find(scene.handle, "base")), PLP_OK);
  plp_body body = 0;
  EXPECT_EQ(plp_scene_find_body(scene.handle, "base", &body), PLP_ERROR_INVALID_ARGUMENT);
  double matrix[16];
  EXPECT_EQ(plp_scene_get_node_matrix(scene.handle, arm, matrix), PLP_ERROR_WRONG_STATE);
  EXPECT_EQ(list(scene.handle).size(), 1u);
}

TEST(GltfScene, LongNamesAreCutBetweenCharacters) {
  std::string name = "x";
  for (int i = 0; i < 100; ++i) name += "\u2603";  // three bytes
  Json json = gltf_of({box(0.5f, 0.5f, 0.5f)});
  add_node(json, {{"name", name}, {"mesh", 0}});
  const GltfFile file(json);
  TestScene scene(0.1);
  ASSERT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), nullptr, nullptr, 0, nullptr), PLP_OK);
  const plp_body body = find(scene.handle, name.c_str());
  EXPECT_EQ(std::string(info_of(scene.handle, body).name), name.substr(0, 253));
}

TEST(GltfScene, ARunningSceneTakesAFile) {
  Json json = gltf_of({box(0.5f, 0.5f, 0.5f)});
  constexpr int kBodies = 600;  // more than a step takes in
  for (int i = 0; i < kBodies; ++i)
    add_node(json,
             {{"name", "box " + std::to_string(i)}, {"mesh", 0}, {"translation", {0, -0.6 - 2.0 * i, 0}}});
  const GltfFile file(json);
  TestScene scene(0.2);
  const TestModel probe(box(0.1f, 0.1f, 0.1f));
  scene.add(probe.handle, PLP_BODY_TOOL, at(0, 0.1, 0));
  ASSERT_EQ(plp_scene_start(scene.handle, nullptr), PLP_OK) << plp_last_error();
  ASSERT_EQ(plp_scene_load_gltf(scene.handle, file.path().c_str(), nullptr, nullptr, 0, nullptr), PLP_OK)
      << plp_last_error();
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  for (int wait = 0; wait < 10'000 && contacts.set_count == 0; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_EQ(plp_scene_get_contacts(scene.handle, &contacts), PLP_OK);
  }
  EXPECT_EQ(contacts.set_count, 1u);
  EXPECT_NEAR(contacts.min_distance, 0.1, 1e-6);
  ASSERT_EQ(plp_scene_stop(scene.handle), PLP_OK);
  EXPECT_EQ(list(scene.handle).size(), kBodies + 1u);
  EXPECT_EQ(scene.step().work.bodies, static_cast<std::uint64_t>(kBodies)) << "all have arrived";
}

// Files of others: a probe beside the bodies of each is as near as beside the one model of the whole scene.
class GltfSceneFile : public testing::TestWithParam<const char*> {};

TEST_P(GltfSceneFile, IsAsNearAsTheBakedModel) {
  const char* data = std::getenv("PALPATE_DATA");
  if (!data) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const std::string path = std::string(data) + "/gltf-features/" + GetParam();
  plp_model baked = nullptr;
  ASSERT_EQ(plp_model_load_file(path.c_str(), nullptr, &baked), PLP_OK) << plp_last_error();
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  ASSERT_EQ(plp_model_get_info(baked, &info), PLP_OK);
  plp_scene_options options = TestScene::options_with(info.diagonal);
  options.mode = PLP_MODE_GLOBAL;
  TestScene bodies(options);
  TestScene whole(options);
  ASSERT_EQ(plp_scene_load_gltf(bodies.handle, path.c_str(), nullptr, nullptr, 0, nullptr), PLP_OK)
      << plp_last_error();
  whole.add(baked, PLP_BODY_STATIC, at(0, 0, 0));
  const auto size = static_cast<float>(0.01 * info.diagonal);
  const TestModel probe(box(size, size, size));
  const plp_body ours = bodies.add(probe.handle, PLP_BODY_TOOL, at(0, 0, 0));
  const plp_body theirs = whole.add(probe.handle, PLP_BODY_TOOL, at(0, 0, 0));
  for (int corner = 0; corner < 8; ++corner) {
    plp_pose pose = {{}, {0.1, 0.2, 0.3, 0.9}};
    for (int axis = 0; axis < 3; ++axis)
      pose.position[axis] = (corner >> axis & 1 ? info.bounds_max : info.bounds_min)[axis] +
                            (corner >> axis & 1 ? 0.05 : -0.05) * info.diagonal;
    ASSERT_EQ(plp_scene_set_pose(bodies.handle, ours, &pose), PLP_OK);
    ASSERT_EQ(plp_scene_set_pose(whole.handle, theirs, &pose), PLP_OK);
    const plp_contacts expected = whole.step();
    const plp_contacts actual = bodies.step();
    EXPECT_TRUE(std::isfinite(expected.min_distance)) << "the probe reaches it";
    EXPECT_NEAR(actual.min_distance, expected.min_distance, 1e-6 * info.diagonal) << "corner " << corner;
  }
  plp_model_release(baked);
}

INSTANTIATE_TEST_SUITE_P(Features, GltfSceneFile,
                         testing::Values("2CylinderEngine.glb", "CesiumMilkTruck.glb", "nested.glb",
                                         "ingenuity/ingenuity.gltf", "mirror/one_face_123_mirror.gltf",
                                         "simple_skin.gltf", "Box_Draco.glb", "duck_quantized.glb"),
                         [](const auto& info) {
                           std::string name = info.param;
                           for (char& byte : name)
                             byte = std::isalnum(static_cast<unsigned char>(byte)) ? byte : '_';
                           return name;
                         });

}  // namespace
}  // namespace palpate::test
