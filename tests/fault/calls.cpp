#include "tests/fault/calls.h"

namespace palpate::test {

void release(Journey& journey, plp_model model) {
  journey("plp_model_release", [&] { return plp_model_release(model); });
}

void release(Journey& journey, plp_scene scene) {
  journey("plp_scene_release", [&] { return plp_scene_release(scene); });
}

plp_model new_model(Journey& journey, const Shape& shape) {
  const plp_triangles triangles = triangles_of(shape);
  plp_model model = nullptr;
  journey("plp_model_create_from_triangles",
          [&] { return plp_model_create_from_triangles(&triangles, nullptr, &model); });
  return model;
}

plp_scene new_scene(Journey& journey, const plp_scene_options& options) {
  plp_scene scene = nullptr;
  journey("plp_scene_create", [&] { return plp_scene_create(&options, &scene); });
  return scene;
}

plp_body add(Journey& journey, plp_scene scene, plp_model model, plp_body_kind kind, const plp_pose& pose) {
  plp_body_options options;
  plp_body_options_init(&options, sizeof options);
  options.model = model;
  options.kind = kind;
  options.pose = pose;
  plp_body body = 0;
  journey("plp_scene_add_body", [&] { return plp_scene_add_body(scene, &options, &body); });
  journey.keep(body);
  return body;
}

void place(Journey& journey, plp_scene scene, plp_body body, const plp_pose& pose) {
  journey("plp_scene_set_pose", [&] { return plp_scene_set_pose(scene, body, &pose); });
}

}  // namespace palpate::test
