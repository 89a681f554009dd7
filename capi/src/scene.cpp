#include <system_error>

#include "capi/src/cutoff.h"
#include "capi/src/handles.h"
#include "capi/src/law.h"
#include "capi/src/numbers.h"
#include "capi/src/structs.h"

namespace palpate::capi {
namespace {

BodyKind kind_of(const plp_body_options& options) {
  switch (raw_enum(options.kind)) {
    case PLP_BODY_STATIC:
      return BodyKind::kStatic;
    case PLP_BODY_MOVING:
      return BodyKind::kMoving;
    case PLP_BODY_TOOL:
      return BodyKind::kTool;
  }
  refuse(ErrorCode::kInvalidArgument, "options->kind is no plp_body_kind");
}

SearchMode mode_of(std::int32_t mode, const char* name) {
  switch (mode) {
    case PLP_MODE_GLOBAL:
      return SearchMode::kGlobal;
    case PLP_MODE_DESCENT:
      return SearchMode::kDescent;
    case PLP_MODE_CERTIFIED:
      return SearchMode::kCertified;
  }
  refuse(ErrorCode::kInvalidArgument, std::string(name) + " is no plp_mode");
}

// Not so short that a velocity is no number.
double time_step_of(double seconds) {
  if (!(seconds >= 1e-6 && seconds <= 1.0))
    refuse_argument("options->time_step", " is not within 1e-6 and 1 s");
  return seconds;
}

bool is_intangible(const plp_body_options& options, BodyKind kind) {
  require(options.intangible == 0 || options.intangible == 1, "options->intangible is neither 0 nor 1");
  require(options.reserved == 0, "options->reserved is not zero");
  require(options.intangible == 0 || kind != BodyKind::kTool,
          "options->intangible is 1 and the body is the tool");
  return options.intangible == 1;
}

// All but the model.
BodyOptions body_in(const plp_body_options& options, const Space& space) {
  BodyOptions body;
  body.kind = kind_of(options);
  body.pose = space.pose_in(options.pose, "options->pose");
  body.stiffness = checked_not_negative(options.stiffness, "options->stiffness");
  body.damping = checked_not_negative(options.damping, "options->damping");
  body.friction = checked(options.friction, "options->friction");
  body.intangible = is_intangible(options, body.kind);
  body.reference_point =
      checked(space.point_in(vector_of(options.reference_point)), "options->reference_point");
  return body;
}

void employ_workers(std::uint32_t threads, SceneObject& object) {
  if (threads <= 1) return;
  try {
    object.workers = std::make_unique<WorkerPool>(threads);
  } catch (const std::system_error&) {
    refuse(ErrorCode::kLimit, "the system has no more threads");
  }
  object.scene.set_executor(object.workers.get());
}

std::unique_ptr<SceneObject> new_scene(const plp_scene_options& options) {
  const Space space(options.space, "options->space");
  SceneOptions scene;
  scene.cutoff = cutoff_in(space, options.cutoff, "options->cutoff");
  scene.stiffness = checked_not_negative(options.stiffness, "options->stiffness");
  scene.max_overlaps = options.max_overlaps;
  scene.mode = mode_of(options.mode, "options->mode");
  scene.law = law_of(options.law, "options->law");
  if (options.global_every > 0) scene.global_every = options.global_every;
  scene.damping = checked_not_negative(options.damping, "options->damping");
  scene.stiffness_cap = checked(options.stiffness_cap, "options->stiffness_cap");
  scene.friction = checked_not_negative(options.friction, "options->friction");
  scene.fade_time = checked_not_negative(options.fade_time, "options->fade_time");
  if (options.time_step != 0.0) scene.time_step = time_step_of(options.time_step);
  scene.tick_budget = options.tick_budget;
  require(options.threads <= WorkerPool::kMostThreads, "options->threads is more than 256");
  auto object = std::make_unique<SceneObject>(space, scene);
  employ_workers(options.threads, *object);
  return object;
}

void show_newest(SceneObject& object) {
  object.scene.visit_newer([&](const Contacts& contacts) { object.arrays.assign(contacts, object.space); });
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_scene_options_init(plp_scene_options* options, size_t size) {
  plp_scene_options filled{};
  filled.max_overlaps = 1024;
  filled.space = kPalpateSpace;
  filled.stiffness = 1000.0;
  filled.mode = PLP_MODE_CERTIFIED;
  filled.law = PLP_LAW_SMOOTH;
  filled.fade_time = 0.02;
  filled.time_step = 0.001;
  fill_struct(filled, options, size);
}

plp_result plp_scene_create(const plp_scene_options* options, plp_scene* scene) {
  return guarded([&] {
    require(scene, "scene is null");
    *scene = new_handle<plp_scene>(scene_table(), new_scene(read_struct(options, "options")));
  });
}

plp_result plp_scene_release(plp_scene scene) {
  return guarded([&] { release_handle(scene_table(), scene, "scene"); });
}

void plp_body_options_init(plp_body_options* options, size_t size) {
  plp_body_options filled{};
  filled.kind = PLP_BODY_STATIC;
  filled.pose.orientation[3] = 1.0;
  fill_struct(filled, options, size);
}

plp_result plp_scene_add_body(plp_scene scene, const plp_body_options* options, plp_body* body) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    require(body, "body is null");
    const plp_body_options given = read_struct(options, "options");
    BodyOptions placed = body_in(given, object->space);
    const auto model = model_table().pin(bits_of(given.model));
    require_handle(model, "options->model");
    placed.model = model->model;
    placed.model_name = model->name;
    *body = value_or_refuse(object->scene.add(std::move(placed)));
  });
}

plp_result plp_scene_remove_body(plp_scene scene, plp_body body) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    require_body(object->scene.remove(body));
  });
}

plp_result plp_scene_set_pose(plp_scene scene, plp_body body, const plp_pose* pose) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    require(pose, "pose is null");
    require_body(object->scene.set_pose(body, object->space.pose_in(*pose, "pose")));
  });
}

plp_result plp_scene_get_pose(plp_scene scene, plp_body body, plp_pose* pose) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    require(pose, "pose is null");
    const std::optional<Pose> found = object->scene.pose_of(body);
    require_body(found.has_value());
    *pose = object->space.pose_out(*found);
  });
}

plp_result plp_scene_set_cutoff(plp_scene scene, double cutoff) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    object->scene.set_cutoff(cutoff_in(object->space, cutoff, "cutoff"));
  });
}

plp_result plp_scene_set_mode(plp_scene scene, int32_t mode) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    object->scene.set_mode(mode_of(mode, "mode"));
  });
}

plp_result plp_scene_set_law(plp_scene scene, int32_t law) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    object->scene.set_law(law_of(law, "law"));
  });
}

plp_result plp_scene_set_stiffness(plp_scene scene, double stiffness) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    object->scene.set_stiffness(checked_not_negative(stiffness, "stiffness"));
  });
}

plp_result plp_scene_set_damping(plp_scene scene, double damping) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    object->scene.set_damping(checked_not_negative(damping, "damping"));
  });
}

plp_result plp_scene_set_stiffness_cap(plp_scene scene, double stiffness_cap) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    object->scene.set_stiffness_cap(checked(stiffness_cap, "stiffness_cap"));
  });
}

plp_result plp_scene_set_friction(plp_scene scene, double friction) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    object->scene.set_friction(checked_not_negative(friction, "friction"));
  });
}

plp_result plp_scene_step(plp_scene scene) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    value_or_refuse(object->scene.step());
  });
}

plp_result plp_scene_get_contacts(plp_scene scene, plp_contacts* contacts) {
  return guarded([&] {
    const auto object = pin_scene(scene);
    require_handle(object, "scene");
    checked_size(contacts, "contacts");
    show_newest(*object);
    write_struct(object->arrays.shown(), contacts, "contacts");
  });
}
