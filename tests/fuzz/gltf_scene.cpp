#include <vector>

#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/sound.h"
#include "tests/fuzz/targets.h"

namespace palpate::fuzz {
namespace {

// So that no input is slow for no other reason than its size.
constexpr std::uint64_t kMostTriangles = 20'000;
constexpr std::uint64_t kMostTouched = 300;
constexpr double kCutoff = 0.1;

plp_scene scene_to_fill() {
  plp_scene_options options;
  plp_scene_options_init(&options, sizeof options);
  options.cutoff = kCutoff;
  options.mode = PLP_MODE_GLOBAL;
  plp_scene scene = nullptr;
  require(checked(plp_scene_create(&options, &scene)) == PLP_OK, "a scene");
  return scene;
}

plp_result load(plp_scene scene, const std::string& path, const char* tool, std::size_t* count) {
  plp_model_options model;
  plp_model_options_init(&model, sizeof model);
  model.max_triangles = kMostTriangles;
  plp_gltf_scene_options options;
  plp_gltf_scene_options_init(&options, sizeof options);
  options.model = &model;
  options.tool = tool;
  return checked(plp_scene_load_gltf(scene, path.c_str(), &options, nullptr, 0, count));
}

std::vector<plp_body> bodies_of(plp_scene scene) {
  std::size_t count = 0;
  require(checked(plp_scene_list_bodies(scene, nullptr, 0, &count)) == PLP_OK, "a count of bodies");
  std::vector<plp_body> bodies(count);
  require(checked(plp_scene_list_bodies(scene, bodies.data(), count, &count)) == PLP_OK, "a list of bodies");
  return bodies;
}

plp_body_info info_of(plp_scene scene, plp_body body) {
  plp_body_info info;
  plp_body_info_init(&info, sizeof info);
  require(checked(plp_scene_get_body_info(scene, body, &info)) == PLP_OK, "an info of a body");
  require(info.stiffness >= 0.0 && info.stiffness - info.stiffness == 0.0, "a stiffness");
  require(info.damping >= 0.0 && info.damping - info.damping == 0.0, "a damping");
  require(info.friction - info.friction == 0.0, "a friction");
  return info;
}

void require_sound_pose(plp_scene scene, plp_body body) {
  plp_pose pose;
  require(checked(plp_scene_get_pose(scene, body, &pose)) == PLP_OK, "a pose of a body");
  for (const double x : pose.position) require(x - x == 0.0, "a finite position");
  for (const double x : pose.orientation) require(x - x == 0.0, "a finite orientation");
}

std::uint64_t triangles_of(plp_scene scene) {
  std::uint64_t triangles = 0;
  for (const plp_body body : bodies_of(scene)) {
    triangles += info_of(scene, body).triangles;
    require_sound_pose(scene, body);
  }
  return triangles;
}

// Its first body's node is the tool, of which the file must have no other.
void touch_with(const std::string& path, const char* tool) {
  const plp_scene scene = scene_to_fill();
  if (load(scene, path, tool, nullptr) == PLP_OK) step(scene, kCutoff);
  require(checked(plp_scene_release(scene)) == PLP_OK, "a scene to release");
}

}  // namespace

void gltf_scene(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(bytes);
  const plp_scene scene = scene_to_fill();
  std::size_t count = 0;
  if (load(scene, file.path(), nullptr, &count) == PLP_OK) {
    require(bodies_of(scene).size() == count, "all bodies");
    if (count > 0 && triangles_of(scene) <= kMostTouched) {
      const plp_body_info first = info_of(scene, bodies_of(scene).front());
      if (*first.name) touch_with(file.path(), first.name);
    }
  } else {
    require(bodies_of(scene).empty(), "no body after an error");
  }
  require(checked(plp_scene_release(scene)) == PLP_OK, "a scene to release");
}

}  // namespace palpate::fuzz
