// A trace tells which nodes of which glTF file its bodies were, so that a replay needs nothing but the two
// files.
#include <unordered_map>

#include "tests/capi/gltf_file.h"
#include "tests/trace/traces.h"

namespace palpate::test {
namespace {

constexpr int kSteps = 120;

// Two nodes are called the same, one has no name, and the tool is a group of two meshes.
Json room() {
  Json json = gltf_of({torus(1.0, 0.35, 24, 12), box(0.2f, 0.2f, 0.2f)});
  add_node(json, {{"name", "ring"}, {"mesh", 0}, {"extras", {{"stiffness", 700}, {"friction", 0}}}});
  const std::size_t stool = add_node(json, {{"name", "stool"}, {"mesh", 1}, {"translation", {0, 0, -0.9}}});
  add_node(json, {{"name", "stool"}, {"mesh", 1}, {"scale", {1, 2, 1}}, {"translation", {0, 0, -1.5}}});
  add_node(json, {{"mesh", 1}, {"translation", {0, 0.7, 0}}}, static_cast<int>(stool));
  const std::size_t pen = add_node(json, {{"name", "pen"}, {"translation", {0.9, 0.1, 0.2}}});
  add_node(json, {{"mesh", 1}}, static_cast<int>(pen));
  add_node(json, {{"mesh", 1}, {"translation", {0, 0.3, 0}}, {"scale", {0.5, 0.5, 0.5}}},
           static_cast<int>(pen));
  return json;
}

std::vector<plp_body> load(plp_scene scene, const GltfFile& file, const std::string& tool) {
  plp_gltf_scene_options options;
  plp_gltf_scene_options_init(&options, sizeof options);
  options.tool = tool.c_str();
  std::vector<plp_body> bodies(16);
  std::size_t count = 0;
  EXPECT_EQ(plp_scene_load_gltf(scene, file.path().c_str(), &options, bodies.data(), bodies.size(), &count),
            PLP_OK)
      << plp_last_error();
  bodies.resize(count);
  return bodies;
}

// What the trace has, as its bodies were called by node, from the file's name on.
std::string node_of(const plp_trace_body& body, const GltfFile& file) {
  const std::string name = body.model_name;
  const std::string begin = std::filesystem::path(file.path()).filename().string() + "#";
  EXPECT_TRUE(name.starts_with(begin)) << name;
  return name.substr(begin.size());
}

std::string node_of(plp_scene scene, plp_body body) {
  plp_body_info info;
  plp_body_info_init(&info, sizeof info);
  EXPECT_EQ(plp_scene_get_body_info(scene, body, &info), PLP_OK) << plp_last_error();
  return "/nodes/" + std::to_string(info.node);
}

class SceneReplay : public testing::TestWithParam<plp_mode> {
 protected:
  plp_scene_options options() const {
    plp_scene_options options = TestScene::options_with(0.3);
    options.mode = GetParam();
    options.law = PLP_LAW_SMOOTH;
    options.friction = 0.2;
    options.damping = 2.0;
    return options;
  }
};

TEST_P(SceneReplay, NeedsTheTraceAndTheFileAlone) {
  const std::uint32_t seed = 5;
  std::printf("seed %u\n", seed);
  const GltfFile file(room());
  TraceFile first;
  std::vector<std::string> told;
  std::size_t lmds = 0;
  {
    TestScene scene(options());
    const std::vector<plp_body> bodies = load(scene.handle, file, "pen");
    ASSERT_EQ(bodies.size(), 5u);
    ASSERT_EQ(plp_scene_record(scene.handle, first.path()), PLP_OK) << plp_last_error();
    Wander wander(0.6, seed);
    plp_pose stool_at = at(0.0, 0.0, -0.9);
    for (int i = 0; i < kSteps; ++i) {
      const plp_pose pose = wander.next();
      ASSERT_EQ(plp_scene_set_pose(scene.handle, bodies.back(), &pose), PLP_OK);
      stool_at.position[0] += 0.002;
      ASSERT_EQ(plp_scene_set_pose(scene.handle, bodies[1], &stool_at), PLP_OK);
      const plp_contacts contacts = scene.step();
      told.push_back(bits_of(contacts));
      lmds += contacts.lmd_count;
    }
    EXPECT_EQ(stop_recording(scene.handle).lost, 0u);
  }
  EXPECT_GT(lmds, std::size_t{kSteps} / 2);

  const TestTrace trace(first);
  ASSERT_EQ(trace.info().bodies, 5u);
  std::string tool;
  for (std::uint64_t i = 0; i < 5; ++i)
    if (trace.body(i).kind == PLP_BODY_TOOL) tool = node_of(trace.body(i), file);
  TestScene scene(trace.options());
  std::unordered_map<std::string, plp_body> bodies;
  for (const plp_body body : load(scene.handle, file, tool)) bodies[node_of(scene.handle, body)] = body;
  ASSERT_EQ(bodies.size(), 5u);
  for (std::uint64_t i = 0; i < kSteps; ++i) {
    for (std::uint64_t b = 0; b < 5; ++b) {
      const plp_trace_body recorded = trace.body(b);
      const auto found = bodies.find(node_of(recorded, file));
      ASSERT_NE(found, bodies.end());
      ASSERT_EQ(plp_trace_place(trace.handle, i, recorded.body, scene.handle, found->second), PLP_OK)
          << plp_last_error();
    }
    EXPECT_EQ(bits_of(scene.step()), told[i]) << "step " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, SceneReplay,
                         testing::Values(PLP_MODE_GLOBAL, PLP_MODE_DESCENT, PLP_MODE_CERTIFIED));

// A model that is taken from a scene and used in another keeps its name.
TEST(SceneTrace, NamesABodyThatWasTakenFromAScene) {
  const GltfFile file(room());
  TestScene source(0.3);
  const std::vector<plp_body> bodies = load(source.handle, file, "/nodes/4");
  plp_model pen = nullptr;
  ASSERT_EQ(plp_scene_get_body_model(source.handle, bodies.back(), &pen), PLP_OK) << plp_last_error();
  TraceFile written;
  TestScene scene(0.3);
  scene.add(pen, PLP_BODY_TOOL, at(0, 0, 0));
  ASSERT_EQ(plp_scene_record(scene.handle, written.path()), PLP_OK) << plp_last_error();
  scene.step();
  stop_recording(scene.handle);
  const TestTrace trace(written);
  EXPECT_EQ(node_of(trace.body(0), file), "/nodes/4");
  plp_model_release(pen);
}

TEST(SceneTrace, CutsALongNameOfAFileAndNotTheNode) {
  std::string name;
  for (int i = 0; i < 122; ++i) name += "\xC3\xA4";  // two bytes each
  const std::filesystem::path path = std::filesystem::temp_directory_path() / (name + ".gltf");
  std::ofstream(path) << room().dump();
  TraceFile written;
  {
    TestScene scene(0.3);
    ASSERT_EQ(plp_scene_load_gltf(scene.handle, path.c_str(), nullptr, nullptr, 0, nullptr), PLP_OK);
    ASSERT_EQ(plp_scene_record(scene.handle, written.path()), PLP_OK) << plp_last_error();
    scene.step();
    stop_recording(scene.handle);
  }
  std::filesystem::remove(path);
  const TestTrace trace(written);
  const std::string told = trace.body(0).model_name;
  EXPECT_LE(told.size(), 255u);
  EXPECT_TRUE(told.ends_with("#/nodes/0")) << told;
  EXPECT_NE(told.substr(0, told.size() - 9).back(), '\xC3') << "a character is cut apart";
}

}  // namespace
}  // namespace palpate::test
