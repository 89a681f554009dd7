#include <algorithm>

#include "capi/src/handles.h"
#include "capi/src/structs.h"
#include "capi/src/text.h"

namespace palpate::capi {
namespace {

plp_body_kind kind_out(BodyKind kind) {
  switch (kind) {
    case BodyKind::kStatic:
      return PLP_BODY_STATIC;
    case BodyKind::kMoving:
      return PLP_BODY_MOVING;
    case BodyKind::kTool:
      return PLP_BODY_TOOL;
  }
  refuse(ErrorCode::kInternal, "a body is of no kind");
}

plp_body_info info_of(const NewBody& body) {
  plp_body_info info{};
  info.kind = kind_out(body.options.kind);
  store_text(body.node.name, info.name);
  info.node = body.node.index;
  info.intangible = body.options.intangible ? 1 : 0;
  info.above = body.node.above;
  info.triangles = body.options.model->mesh().triangles.size();
  info.stiffness = body.options.stiffness;
  info.damping = body.options.damping;
  info.friction = body.options.friction;
  return info;
}

NewBody added_or_refuse(SceneObject& object, plp_body body) {
  std::optional<NewBody> found = object.scene.as_added(body);
  require_body(found.has_value());
  return std::move(*found);
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_body_info_init(plp_body_info* info, size_t size) {
  fill_struct(plp_body_info{}, info, size);
}

plp_result plp_scene_get_body_info(plp_scene scene, plp_body body, plp_body_info* info) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    write_struct(info_of(added_or_refuse(*object, body)), info, "info");
  });
}

plp_result plp_scene_list_bodies(plp_scene scene, plp_body* bodies, size_t capacity, size_t* count) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    require(count, "count is null");
    require(bodies || capacity == 0, "bodies is null and capacity is not 0");
    const std::vector<BodyId> found = object->scene.bodies();
    std::copy_n(found.begin(), std::min(found.size(), capacity), bodies);
    *count = found.size();
  });
}

plp_result plp_scene_find_body(plp_scene scene, const char* name, plp_body* body) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    require(name && *name, "name is null or empty");
    require(body, "body is null");
    const BodyId found = object->scene.find_named(name);
    if (found == 0)
      refuse(ErrorCode::kInvalidArgument, "no body of the scene is called \"" + std::string(name) + '"');
    *body = found;
  });
}

plp_result plp_scene_get_body_model(plp_scene scene, plp_body body, plp_model* model) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    require(model, "model is null");
    BodyOptions options = added_or_refuse(*object, body).options;
    auto shared = std::make_unique<ModelObject>();
    shared->model = std::move(options.model);
    shared->name = std::move(options.model_name);
    *model = new_handle<plp_model>(model_table(), std::move(shared));
  });
}

plp_result plp_scene_get_node_matrix(plp_scene scene, plp_body body, double* matrix) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    require(matrix, "matrix is null");
    const DMat4 parent_from_node = value_or_refuse(object->scene.parent_from_node(body));
    for (int i = 0; i < 16; ++i) matrix[i] = parent_from_node[i / 4][i % 4];
  });
}
