#include <algorithm>

#include "capi/src/cutoff.h"
#include "capi/src/handles.h"
#include "capi/src/log.h"
#include "capi/src/model_options.h"
#include "capi/src/structs.h"
#include "capi/src/text.h"
#include "engine/base/clock.h"
#include "engine/gltf/gltf_bodies.h"
#include "engine/gltf/gltf_file.h"
#include "engine/trace/layout.h"

namespace palpate::capi {
namespace {

plp_gltf_scene_options default_options() {
  plp_gltf_scene_options options{};
  options.struct_size = sizeof options;
  options.pose.orientation[3] = 1.0;
  return options;
}

// What a caller wants, checked and in Palpate's space.
struct SceneLoad {
  std::string name;  // of the file
  plp_model_options model;
  std::string tool;
  Pose world_from_file;
  double cutoff = 0.0;  // metres; 0: as it is
};

SceneLoad load_in(const char* path, const plp_gltf_scene_options& options, const Space& space) {
  require(path && *path, "path is null or empty");
  require(options.flags == 0, "options->flags has a flag that this version does not know");
  require(!options.tool || *options.tool, "options->tool is empty");
  SceneLoad load;
  load.name = path;
  load.model = checked_model_options(options.model, "options->model");
  load.tool = options.tool ? options.tool : "";
  load.world_from_file = space.pose_in(options.pose, "options->pose");
  if (options.cutoff != 0.0) load.cutoff = cutoff_in(space, options.cutoff, "options->cutoff");
  return load;
}

GltfBodies read_bodies(const SceneLoad& load) {
  GltfOptions how = gltf_options(load.model);
  how.hierarchy = true;
  GltfScene scene = value_or_refuse(read_gltf_file(path_of(load.name.c_str()), how));
  Result<GltfBodies> found = gather_bodies(scene, load.tool, mesh_options(load.model), scale_of(load.model));
  if (!found) refuse(found.error().code, load.name + ": " + found.error().message);
  GltfBodies bodies = std::move(found.value());
  bodies.notes.insert(bodies.notes.begin(), scene.notes.begin(), scene.notes.end());
  return bodies;
}

std::vector<std::shared_ptr<const Model>> models_of(std::vector<Mesh> shapes) {
  std::vector<std::shared_ptr<const Model>> models;
  models.reserve(shapes.size());
  for (Mesh& shape : shapes) models.push_back(std::make_shared<const Model>(std::move(shape)));
  return models;
}

BodyKind kind_of(const GltfBody& body) {
  if (body.tool) return BodyKind::kTool;
  return body.moves ? BodyKind::kMoving : BodyKind::kStatic;
}

// A friction of 0 is none in a file, and the scene's in BodyOptions.
double friction_of(const HapticMaterial& material) {
  return material.friction == 0.0 ? -1.0 : material.friction.value_or(0.0);
}

// Of the file and, in it, of the node: a trace keeps both, and a replay finds the model by them.
std::string model_name(const SceneLoad& load, const GltfBody& body) {
  const std::string file = path_of(load.name.c_str()).filename().string();
  const std::string node = "#/nodes/" + std::to_string(body.node);
  return file.substr(0, fitting_length(file, kLongestTraceName - node.size())) + node;
}

NewBody new_body(const GltfBody& body, std::shared_ptr<const Model> model, const SceneLoad& load) {
  NewBody made;
  made.options.model_name = model_name(load, body);
  made.options.kind = kind_of(body);
  made.options.model = std::move(model);
  made.options.pose = load.world_from_file * body.scene_from_body;
  if (!in_range(made.options.pose.translation))
    refuse(ErrorCode::kLimit,
           load.name + ": node " + std::to_string(body.node) + " is farther away than 1e15 m");
  made.options.stiffness = body.material.stiffness.value_or(0.0);
  made.options.damping = body.material.damping.value_or(0.0);
  made.options.friction = friction_of(body.material);
  made.options.intangible = !body.touches_tool;
  made.node.name = body.name;
  made.node.index = static_cast<std::int32_t>(body.node);
  made.node.above = body.above < 0 ? 0 : static_cast<BodyId>(body.above) + 1;
  made.node.above_from_parent =
      body.above < 0 ? matrix_of(load.world_from_file) * body.above_from_parent : body.above_from_parent;
  made.node.body_from_node = body.body_from_node;
  return made;
}

void log_scene(const SceneLoad& load, const GltfBodies& bodies, double load_us) {
  for (const std::string& note : bodies.notes) log_quietly(LogLevel::kWarning, load.name + ": " + note);
  for (const Mesh& shape : bodies.shapes) log_model(load.name, shape.report, load_us);
}

std::vector<NewBody> new_bodies(GltfBodies bodies, const SceneLoad& load) {
  const std::vector<std::shared_ptr<const Model>> models = models_of(std::move(bodies.shapes));
  std::vector<NewBody> made;
  for (const GltfBody& body : bodies.bodies) made.push_back(new_body(body, models[body.shape], load));
  return made;
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_gltf_scene_options_init(plp_gltf_scene_options* options, size_t size) {
  fill_struct(default_options(), options, size);
}

plp_result plp_scene_load_gltf(plp_scene scene, const char* path, const plp_gltf_scene_options* options,
                               plp_body* bodies, size_t capacity, size_t* count) {
  return guarded([&] {
    const Stopwatch watch;
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    require(bodies || capacity == 0, "bodies is null and capacity is not 0");
    const plp_gltf_scene_options given = options ? read_struct(options, "options") : default_options();
    const SceneLoad load = load_in(path, given, object->space);
    GltfBodies found = read_bodies(load);
    log_scene(load, found, watch.elapsed_us());
    const std::vector<BodyId> added =
        value_or_refuse(object->scene.add_all(new_bodies(std::move(found), load), load.cutoff));
    std::copy_n(added.begin(), std::min(added.size(), capacity), bodies);
    if (count) *count = added.size();
  });
}
