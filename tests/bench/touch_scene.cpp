#include "tests/bench/touch_scene.h"

#include "tests/bench/method.h"

namespace palpate::bench {

plp_pose pose_of(const Pose& pose) {
  const DQuat q = glm::quat_cast(pose.rotation);
  const DVec3& p = pose.translation;
  return {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}};
}

cli::OwnedModel public_model(const Model& model) {
  const Mesh& mesh = model.mesh();
  std::vector<DVec3> positions;
  for (const Vec3& position : mesh.positions) positions.push_back(mesh.frame.metres(DVec3(position)));
  plp_triangles triangles;
  plp_triangles_init(&triangles, sizeof triangles);
  triangles.positions = positions.data();
  triangles.position_type = PLP_TYPE_FLOAT64;
  triangles.vertex_count = positions.size();
  triangles.indices = mesh.triangles.data();
  triangles.triangle_count = mesh.triangles.size();
  cli::OwnedModel handle;
  cli::check(plp_model_create_from_triangles(&triangles, nullptr, handle.receive()));
  cli::check(plp_model_prepare(handle.get()));
  return handle;
}

TouchScene::TouchScene(double cutoff, plp_mode mode, Law law, unsigned global_every) {
  plp_scene_options options;
  plp_scene_options_init(&options, sizeof options);
  options.cutoff = cutoff;
  options.stiffness = kStiffness;
  options.mode = mode;
  options.global_every = global_every;
  options.fade_time = 0.0;  // a spring that fades after its LMD has gone would count as an error
  choose(law, options);
  cli::check(plp_scene_create(&options, scene_.receive()));
}

void TouchScene::add_static(plp_model model, const Pose& pose) {
  plp_body_options options;
  plp_body_options_init(&options, sizeof options);
  options.model = model;
  options.pose = pose_of(pose);
  add(options);
}

void TouchScene::add_tool(plp_model model, const DVec3& reference_point) {
  plp_body_options options;
  plp_body_options_init(&options, sizeof options);
  options.model = model;
  options.kind = PLP_BODY_TOOL;
  for (int axis = 0; axis < 3; ++axis) options.reference_point[axis] = reference_point[axis];
  tool_ = add(options);
}

plp_body TouchScene::add(const plp_body_options& options) {
  plp_body body = 0;
  cli::check(plp_scene_add_body(scene_.get(), &options, &body));
  return body;
}

void TouchScene::step(const Pose& world_from_tool) {
  const plp_pose pose = pose_of(world_from_tool);
  cli::check(plp_scene_set_pose(scene_.get(), tool_, &pose));
  cli::check(plp_scene_step(scene_.get()));
}

plp_contacts TouchScene::contacts() const {
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  cli::check(plp_scene_get_contacts(scene_.get(), &contacts));
  return contacts;
}

}  // namespace palpate::bench
