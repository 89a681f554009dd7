// One scene in the spaces of several engines, against the numbers of space_vectors.json, which the bindings
// are held to as well.
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

using Json = nlohmann::json;

Json golden() {
  return Json::parse(std::ifstream(PALPATE_SPACE_VECTORS));
}

plp_space space_of(const Json& vectors) {
  plp_space space{};
  for (std::size_t i = 0; i < 3; ++i) space.axes[i] = vectors["axes"][i];
  space.metres_per_unit = vectors["metres_per_unit"];
  return space;
}

plp_pose pose_of(const Json& body) {
  plp_pose pose{};
  for (std::size_t i = 0; i < 3; ++i) pose.position[i] = body["position"][i];
  for (std::size_t i = 0; i < 4; ++i) pose.orientation[i] = body["orientation"][i];
  return pose;
}

// A model whose winding is trusted, so that a wrong one is not repaired.
plp_model model_of(const Json& body, const plp_space& space) {
  std::vector<double> positions;
  for (const Json& vertex : body["vertices"]) positions.insert(positions.end(), vertex.begin(), vertex.end());
  std::vector<std::uint32_t> indices;
  for (const Json& corners : body["triangles"]) indices.insert(indices.end(), corners.begin(), corners.end());
  plp_triangles triangles;
  plp_triangles_init(&triangles, sizeof triangles);
  triangles.positions = positions.data();
  triangles.position_type = PLP_TYPE_FLOAT64;
  triangles.vertex_count = positions.size() / 3;
  triangles.indices = indices.data();
  triangles.triangle_count = indices.size() / 3;
  triangles.space = space;
  plp_model_options options;
  plp_model_options_init(&options, sizeof options);
  options.flags = PLP_MODEL_KEEP_WINDING;
  plp_model model = nullptr;
  EXPECT_EQ(plp_model_create_from_triangles(&triangles, &options, &model), PLP_OK) << plp_last_error();
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  EXPECT_EQ(plp_model_get_info(model, &info), PLP_OK);
  EXPECT_EQ(info.searched.orientation, PLP_ORIENTATION_OUTWARD);
  return model;
}

void expect_vector(const double actual[3], const Json& expected, double tolerance, const char* what) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i].get<double>(), tolerance) << what;
}

TEST(Spaces, EveryEngineFeelsTheSame) {
  const Json vectors = golden();
  ASSERT_GE(vectors["spaces"].size(), 5u);
  for (const Json& told : vectors["spaces"]) {
    SCOPED_TRACE(told["name"].get<std::string>());
    plp_scene_options options = TestScene::options_with(told["cutoff"]);
    options.space = space_of(told);
    options.stiffness = vectors["stiffness"];
    TestScene scene(options);
    const plp_model still = model_of(told["body"], options.space);
    const plp_model moved = model_of(told["tool"], options.space);
    scene.add(still, PLP_BODY_STATIC, pose_of(told["body"]));
    const plp_body tool = scene.add(moved, PLP_BODY_TOOL, pose_of(told["tool"]));
    const plp_contacts contacts = scene.step();
    EXPECT_EQ(contacts.set_count, 1u);
    EXPECT_NEAR(contacts.min_distance, told["distance"].get<double>(), 1e-5 * told["cutoff"].get<double>());
    expect_vector(contacts.wrench.force, told["force"], 1e-3, "force");
    expect_vector(contacts.wrench.torque, told["torque"], 1e-3, "torque");
    plp_pose pose{};
    EXPECT_EQ(plp_scene_get_pose(scene.handle, tool, &pose), PLP_OK);
    expect_vector(pose.position, told["tool"]["position"], 1e-9, "position");
    plp_model_release(still);
    plp_model_release(moved);
  }
}

}  // namespace
}  // namespace palpate::test
