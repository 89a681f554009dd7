#include "samples/cli/run_models.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace palpate::cli {
namespace {

// Such as "/nodes/5" of "room.glb#/nodes/5"; empty if the body was no node of a glTF scene.
std::string node_of(const plp_trace_body& body) {
  const std::string_view name = body.model_name ? body.model_name : "";
  const std::size_t hash = name.rfind("#/nodes/");
  return std::string(hash == name.npos ? "" : name.substr(hash + 1));
}

// The models of the bodies of a glTF scene, by their nodes.
class SceneModels {
 public:
  // `tool` is a node; empty: none.
  SceneModels(const RunArguments& arguments, const std::string& tool) : file_(arguments.a) {
    plp_scene_options options;
    plp_scene_options_init(&options, sizeof options);
    options.cutoff = 1.0;  // nothing is searched
    check(plp_scene_create(&options, scene_.receive()));
    plp_model_options model;
    plp_model_options_init(&model, sizeof model);
    model.scale = arguments.scale_a;
    plp_gltf_scene_options how;
    plp_gltf_scene_options_init(&how, sizeof how);
    how.model = &model;
    how.tool = tool.empty() ? nullptr : tool.c_str();
    check(plp_scene_load_gltf(scene_.get(), file_.c_str(), &how, nullptr, 0, nullptr));
    list_nodes();
  }

  OwnedModel model_of(const std::string& node) const {
    const auto found = bodies_.find(node);
    if (found == bodies_.end()) throw Failure(file_ + ": has no body " + node + ", as the trace has");
    OwnedModel model;
    check(plp_scene_get_body_model(scene_.get(), found->second, model.receive()));
    check(plp_model_prepare(model.get()));
    return model;
  }

 private:
  void list_nodes() {
    std::size_t count = 0;
    check(plp_scene_list_bodies(scene_.get(), nullptr, 0, &count));
    std::vector<plp_body> ids(count);
    check(plp_scene_list_bodies(scene_.get(), ids.data(), ids.size(), &count));
    for (const plp_body id : ids) {
      plp_body_info info;
      plp_body_info_init(&info, sizeof info);
      check(plp_scene_get_body_info(scene_.get(), id, &info));
      bodies_.emplace("/nodes/" + std::to_string(info.node), id);
    }
  }

  const std::string file_;
  OwnedScene scene_;
  std::unordered_map<std::string, plp_body> bodies_;
};

// One that stands still and a tool, neither of a scene.
std::vector<OwnedModel> pair_of(const RunArguments& arguments, const std::vector<plp_trace_body>& bodies) {
  if (bodies.size() != 2)
    throw Failure(arguments.trajectory + ": has not two bodies, and they are of no glTF scene");
  if (arguments.b.empty()) throw Failure("the model that moves is missing");
  std::vector<OwnedModel> models;
  for (const plp_trace_body& body : bodies) {
    const bool tool = body.kind == PLP_BODY_TOOL;
    models.push_back(tool ? load_model(arguments.b, arguments.scale_b)
                          : load_model(arguments.a, arguments.scale_a));
  }
  return models;
}

OwnedModel tool_beside(const RunArguments& arguments, const plp_trace_body& body) {
  if (body.kind != PLP_BODY_TOOL)
    throw Failure(arguments.trajectory + ": a body beside the glTF scene is not the tool");
  if (arguments.b.empty())
    throw Failure(arguments.trajectory + ": its tool is no node of a scene, but a model to name");
  return load_model(arguments.b, arguments.scale_b);
}

}  // namespace

RunModels::RunModels(const RunArguments& arguments, const Motion& motion) {
  bool of_scene = false;
  std::string tool;  // node
  for (const plp_trace_body& body : motion.bodies()) {
    of_scene = of_scene || !node_of(body).empty();
    if (body.kind == PLP_BODY_TOOL) tool = node_of(body);
  }
  if (!of_scene) {
    models_ = pair_of(arguments, motion.bodies());
    return;
  }
  if (!tool.empty() && !arguments.b.empty())
    throw Failure(arguments.b + ": the tool of " + arguments.trajectory + " is a node of the scene");
  const SceneModels scene(arguments, tool);
  for (const plp_trace_body& body : motion.bodies()) {
    const std::string node = node_of(body);
    models_.push_back(node.empty() ? tool_beside(arguments, body) : scene.model_of(node));
  }
}

double RunModels::diagonal(std::size_t body) const {
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  check(plp_model_get_info(models_[body].get(), &info));
  return info.diagonal;
}

}  // namespace palpate::cli
