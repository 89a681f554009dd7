/* A program that uses what the first palpate.h had. It is built with that header, with today's and with a
   newer one, whose structs are longer, and must print the same with each: the library reads and writes of a
   struct as much as its program knows. */
#include <palpate/palpate.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BEYOND 64
#define CANARY 0xA5

/* A struct as this program knows it, and memory behind it that is not the library's. */
#define GUARDED(type, name)       \
  struct {                        \
    type value;                   \
    unsigned char beyond[BEYOND]; \
  } name;                         \
  memset(&(name), CANARY, sizeof(name))
#define EXPECT_GUARD(name) expect_guard((name).beyond, #name)
#define INIT(type, name) \
  GUARDED(type, name);   \
  type##_init(&(name).value, sizeof(name).value)

static void expect_guard(const unsigned char* beyond, const char* name) {
  int i;
  for (i = 0; i < BEYOND; ++i) {
    if (beyond[i] != CANARY) {
      fprintf(stderr, "something was written behind %s\n", name);
      exit(1);
    }
  }
}

static void check(plp_result result, const char* what) {
  if (result >= 0) return;
  fprintf(stderr, "%s: %s: %s\n", what, plp_result_string(result), plp_last_error());
  exit(1);
}

#define CHECK(call) check(call, #call)

static void print_numbers(const char* what, const double* numbers, size_t count) {
  size_t i;
  printf("%s", what);
  for (i = 0; i < count; ++i) printf(" %a", numbers[i]);
  printf("\n");
}

static plp_model make_box(double half) {
  static const unsigned char corners[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                            2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  double positions[24];
  plp_model model = NULL;
  int i;
  INIT(plp_triangles, triangles);
  INIT(plp_model_options, options);
  for (i = 0; i < 24; ++i)
    positions[i] = i % 3 == 2 ? (i / 12 ? half : -half) : (i / 3 >> i % 3 & 1 ? half : -half);
  triangles.value.positions = positions;
  triangles.value.position_type = PLP_TYPE_FLOAT64;
  triangles.value.vertex_count = 8;
  triangles.value.indices = corners;
  triangles.value.index_type = PLP_TYPE_UINT8;
  triangles.value.triangle_count = 12;
  options.value.weld_tolerance = 1e-9;
  CHECK(plp_model_create_from_triangles(&triangles.value, &options.value, &model));
  EXPECT_GUARD(triangles);
  EXPECT_GUARD(options);
  return model;
}

static void print_model(plp_model model) {
  INIT(plp_model_info, info);
  CHECK(plp_model_prepare(model));
  CHECK(plp_model_get_info(model, &info.value));
  EXPECT_GUARD(info);
  printf("model %d %d %d %d\n", (int)info.value.searched.triangles, (int)info.value.searched.edges,
         (int)info.value.searched.watertight, (int)info.value.tree_nodes);
  print_numbers("bounds", info.value.bounds_max, 3);
}

/* Arrays are stepped through by the stride that comes with them, whatever this program's struct is. */
static void print_contacts(const plp_contacts* contacts) {
  size_t i;
  printf("contacts %d %d %d\n", (int)contacts->set_count, (int)contacts->lmd_count, (int)contacts->overlap);
  print_numbers("wrench", contacts->wrench.force, 3);
  print_numbers("torque", contacts->wrench.torque, 3);
  for (i = 0; i < contacts->lmd_count; ++i) {
    const plp_lmd* lmd = (const plp_lmd*)((const char*)contacts->lmds + i * contacts->lmd_stride);
    printf("lmd %d %d %d\n", (int)lmd->set, (int)lmd->feature_a, (int)lmd->triangle_b);
    print_numbers("points", lmd->point_a, 6);
  }
}

static void query(plp_model a, plp_model b) {
  const plp_pose pose = {{0.03, 0.35, 0.01}, {0.0, 0.0, 0.1, 0.995}};
  plp_query_result result = NULL;
  INIT(plp_query_options, options);
  INIT(plp_contacts, contacts);
  options.value.cutoff = 0.1;
  CHECK(plp_query_result_create(&result));
  CHECK(plp_query(a, b, &pose, &options.value, result));
  CHECK(plp_query_result_get(result, &contacts.value));
  EXPECT_GUARD(options);
  EXPECT_GUARD(contacts);
  print_contacts(&contacts.value);
  CHECK(plp_query_result_release(result));
}

static plp_body add(plp_scene scene, plp_model model, plp_body_kind kind, double height) {
  plp_body body = 0;
  INIT(plp_body_options, options);
  options.value.model = model;
  options.value.kind = kind;
  options.value.pose.position[1] = height;
  CHECK(plp_scene_add_body(scene, &options.value, &body));
  EXPECT_GUARD(options);
  return body;
}

static plp_scene make_scene(void) {
  plp_scene scene = NULL;
  INIT(plp_scene_options, options);
  options.value.cutoff = 0.02;
  options.value.damping = 1.0;
  CHECK(plp_scene_create(&options.value, &scene));
  EXPECT_GUARD(options);
  return scene;
}

static void step_and_print(plp_scene scene) {
  INIT(plp_contacts, contacts);
  CHECK(plp_scene_step(scene));
  CHECK(plp_scene_get_contacts(scene, &contacts.value));
  EXPECT_GUARD(contacts);
  print_contacts(&contacts.value);
}

static void print_servo(plp_scene scene) {
  INIT(plp_servo_options, options);
  INIT(plp_servo_state, state);
  options.value.rate = 500.0;
  options.value.priority = -1;
  CHECK(plp_scene_start(scene, &options.value));
  CHECK(plp_scene_get_servo(scene, &state.value));
  CHECK(plp_scene_stop(scene));
  EXPECT_GUARD(options);
  EXPECT_GUARD(state);
  printf("servo %g\n", state.value.wanted_rate);
}

/* A simulated hand presses the tool down on what is below. */
static plp_device open_device(void) {
  plp_device device = NULL;
  INIT(plp_device_info, info);
  INIT(plp_safety_limits, limits);
  INIT(plp_hand_options, hand);
  CHECK(plp_device_open("sim:premium6dof", &device));
  CHECK(plp_device_get_info(device, &info.value));
  limits.value.max_force = 1.5;
  CHECK(plp_device_set_limits(device, &limits.value));
  hand.value.script = PLP_HAND_PRESS;
  hand.value.period = 0.1;
  CHECK(plp_device_set_hand(device, &hand.value));
  EXPECT_GUARD(info);
  EXPECT_GUARD(limits);
  EXPECT_GUARD(hand);
  printf("device %s %g\n", info.value.name, info.value.max_force);
  return device;
}

static void feel(plp_scene scene) {
  plp_device device = open_device();
  int i;
  INIT(plp_device_mapping, mapping);
  INIT(plp_device_state, state);
  mapping.value.scene_from_base.position[1] = 0.315;
  CHECK(plp_scene_set_device(scene, device, &mapping.value));
  CHECK(plp_device_arm(device));
  for (i = 0; i < 500; ++i) CHECK(plp_scene_step(scene));
  CHECK(plp_device_get_state(device, &state.value));
  EXPECT_GUARD(mapping);
  EXPECT_GUARD(state);
  printf("safety %d limiters %x\n", (int)state.value.safety, (unsigned)state.value.limiters);
  print_numbers("applied", state.value.applied.force, 3);
  CHECK(plp_scene_set_device(scene, NULL, NULL));
  CHECK(plp_device_release(device));
}

int main(void) {
  plp_model floor = make_box(0.2);
  plp_model tool = make_box(0.1);
  plp_scene scene = make_scene();
  print_model(floor);
  query(floor, tool);
  add(scene, floor, PLP_BODY_STATIC, 0.0);
  add(scene, tool, PLP_BODY_TOOL, 0.315);
  step_and_print(scene);
  feel(scene);
  step_and_print(scene);
  print_servo(scene);
  CHECK(plp_scene_release(scene));
  CHECK(plp_model_release(tool));
  CHECK(plp_model_release(floor));
  return 0;
}
