/* A program that is built with a newer header than the library's and fills in what only that has: an input
   that says more than this library understands is refused, and what it gives leaves the new fields zero. */
#include <palpate/palpate.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  failures += 1;
  fprintf(stderr, "does not hold: %s; last error: %s\n", what, plp_last_error());
}

#define EXPECT(holds) expect(holds, #holds)
#define EXPECT_OK(call) expect((call) >= 0, #call)
#define INIT(type, name)            \
  type name;                        \
  memset(&name, 0xA5, sizeof name); \
  type##_init(&name, sizeof name);  \
  expect(name.later == 0 && name.later_still[4] == 0.0, #type "_init zeroes what it does not know")

/* `call` is refused while a new field of `options` is set, and works once it is zero. The sentence says why.
 */
#define EXPECT_REFUSED(call, options)                                                        \
  options.later_still[4] = 1.0;                                                              \
  expect((call) == PLP_ERROR_INVALID_ARGUMENT, #call " with a new field set");               \
  expect(strstr(plp_last_error(), "this version does not have") != NULL, #call " says why"); \
  options.later_still[4] = 0.0;                                                              \
  EXPECT_OK(call)
#define EXPECT_ZERO_TAIL(name)                                                             \
  expect(name.later == 0 && name.later_still[4] == 0.0 && name.struct_size == sizeof name, \
         #name " has no new field")

static plp_model make_triangle(void) {
  static const float positions[9] = {0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f};
  plp_model model = NULL;
  INIT(plp_triangles, triangles);
  INIT(plp_model_options, options);
  triangles.positions = positions;
  triangles.vertex_count = 3;
  EXPECT_REFUSED(plp_model_create_from_triangles(&triangles, NULL, &model), triangles);
  EXPECT_OK(plp_model_release(model));
  EXPECT_REFUSED(plp_model_create_from_triangles(&triangles, &options, &model), options);
  return model;
}

static void query(plp_model model) {
  const plp_pose pose = {{0.25, 0.0, 0.0}, {0.0, 0.0, 0.0, 1.0}};
  plp_query_result result = NULL;
  INIT(plp_query_options, options);
  INIT(plp_contacts, contacts);
  INIT(plp_model_info, info);
  options.cutoff = 0.5;
  EXPECT_OK(plp_query_result_create(&result));
  EXPECT_REFUSED(plp_query(model, model, &pose, &options, result), options);
  EXPECT_OK(plp_query_result_get(result, &contacts));
  EXPECT_ZERO_TAIL(contacts);
  EXPECT(contacts.set_count == 1 && contacts.lmd_stride < sizeof(plp_lmd));
  EXPECT_OK(plp_query_result_release(result));
  EXPECT_OK(plp_model_get_info(model, &info));
  EXPECT_ZERO_TAIL(info);
}

static plp_scene make_scene(plp_model model) {
  plp_scene scene = NULL;
  plp_body body = 0;
  INIT(plp_scene_options, options);
  INIT(plp_body_options, part);
  INIT(plp_body_info, info);
  options.cutoff = 0.1;
  EXPECT_REFUSED(plp_scene_create(&options, &scene), options);
  part.model = model;
  part.kind = PLP_BODY_TOOL;
  EXPECT_REFUSED(plp_scene_add_body(scene, &part, &body), part);
  EXPECT_OK(plp_scene_get_body_info(scene, body, &info));
  EXPECT_ZERO_TAIL(info);
  return scene;
}

/* A file that is not there: the options are looked at first. */
static void load(plp_scene scene) {
  INIT(plp_gltf_scene_options, options);
  options.later = 1;
  EXPECT(plp_scene_load_gltf(scene, "none.glb", &options, NULL, 0, NULL) == PLP_ERROR_INVALID_ARGUMENT);
  options.later = 0;
  EXPECT(plp_scene_load_gltf(scene, "none.glb", &options, NULL, 0, NULL) == PLP_ERROR_FILE_NOT_FOUND);
}

static void serve(plp_scene scene) {
  INIT(plp_servo_options, options);
  INIT(plp_servo_state, state);
  EXPECT_REFUSED(plp_scene_start(scene, &options), options);
  EXPECT_OK(plp_scene_get_servo(scene, &state));
  EXPECT_ZERO_TAIL(state);
  EXPECT_OK(plp_scene_stop(scene));
}

/* Of a list the first one's size counts for all. */
static void list(void) {
  plp_device_info infos[8];
  size_t count = 0;
  size_t i;
  memset(infos, 0, sizeof infos);
  for (i = 0; i < 8; ++i) plp_device_info_init(&infos[i], sizeof infos[i]);
  EXPECT_OK(plp_device_list(infos, 8, &count));
  EXPECT(count >= 2 && infos[1].uri[0] != 0);
  EXPECT_ZERO_TAIL(infos[1]);
}

static void feel(plp_scene scene) {
  plp_device device = NULL;
  INIT(plp_device_info, info);
  INIT(plp_device_state, state);
  INIT(plp_safety_limits, limits);
  INIT(plp_hand_options, hand);
  INIT(plp_device_mapping, mapping);
  EXPECT_OK(plp_device_open("sim:touch", &device));
  EXPECT_OK(plp_device_get_info(device, &info));
  EXPECT_ZERO_TAIL(info);
  EXPECT_REFUSED(plp_device_set_limits(device, &limits), limits);
  EXPECT_REFUSED(plp_device_set_hand(device, &hand), hand);
  EXPECT_REFUSED(plp_scene_set_device(scene, device, &mapping), mapping);
  EXPECT_OK(plp_device_get_state(device, &state));
  EXPECT_ZERO_TAIL(state);
  EXPECT_OK(plp_scene_set_device(scene, NULL, NULL));
  EXPECT_OK(plp_device_release(device));
}

static void record(plp_scene scene, const char* path) {
  INIT(plp_recording, recording);
  EXPECT_OK(plp_scene_record(scene, path));
  EXPECT_OK(plp_scene_step(scene));
  EXPECT_OK(plp_scene_get_recording(scene, &recording));
  EXPECT_ZERO_TAIL(recording);
  EXPECT_OK(plp_scene_stop_recording(scene, &recording));
  EXPECT(recording.ticks == 1);
}

static void replay(const char* path) {
  plp_trace trace = NULL;
  INIT(plp_trace_info, info);
  INIT(plp_trace_body, body);
  INIT(plp_trace_tick, tick);
  INIT(plp_scene_options, options);
  EXPECT_OK(plp_trace_open(path, &trace));
  EXPECT_OK(plp_trace_get_info(trace, &info));
  EXPECT_ZERO_TAIL(info);
  EXPECT_OK(plp_trace_get_body(trace, 0, &body));
  EXPECT_ZERO_TAIL(body);
  EXPECT_OK(plp_trace_read(trace, 0, &tick));
  EXPECT_ZERO_TAIL(tick);
  EXPECT(tick.move_stride < sizeof(plp_trace_move));
  EXPECT_OK(plp_trace_get_options(trace, &options));
  EXPECT_ZERO_TAIL(options);
  EXPECT_OK(plp_trace_release(trace));
}

int main(int count, char** arguments) {
  plp_model model = make_triangle();
  plp_scene scene = make_scene(model);
  if (count != 2) return 2;
  query(model);
  load(scene);
  serve(scene);
  list();
  feel(scene);
  record(scene, arguments[1]);
  replay(arguments[1]);
  EXPECT_OK(plp_scene_release(scene));
  EXPECT_OK(plp_model_release(model));
  return failures != 0;
}
