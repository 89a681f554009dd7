/* Compiled as strict C99 with nothing but the public header: it pins the layout that bindings rely on. */
#include <palpate/palpate.h>
#include <stdio.h>
#include <string.h>

#define PIN(name, condition) typedef char pin_##name[(condition) ? 1 : -1]
#define PIN_SIZE(type, size) PIN(size_of_##type, sizeof(type) == (size))
#define PIN_OFFSET(type, field, offset) PIN(type##_##field, offsetof(type, field) == (offset))

PIN_SIZE(plp_result, 4);
PIN_SIZE(plp_model, 8);
PIN_SIZE(plp_body, 8);
PIN_SIZE(plp_type, 4);
PIN_SIZE(plp_body_kind, 4);
PIN_SIZE(plp_pose, 56);
PIN_OFFSET(plp_pose, orientation, 24);
PIN_SIZE(plp_wrench, 48);
PIN_SIZE(plp_space, 24);
PIN_OFFSET(plp_space, metres_per_unit, 16);
PIN_SIZE(plp_model_options, 40);
PIN_OFFSET(plp_model_options, weld_tolerance, 8);
PIN_OFFSET(plp_model_options, gltf_scene, 16);
PIN_OFFSET(plp_model_options, max_triangles, 24);
PIN_OFFSET(plp_model_options, scale, 32);
PIN_SIZE(plp_triangles, 88);
PIN_OFFSET(plp_triangles, positions, 8);
PIN_OFFSET(plp_triangles, indices, 32);
PIN_OFFSET(plp_triangles, triangle_count, 48);
PIN_OFFSET(plp_triangles, position_type, 56);
PIN_OFFSET(plp_triangles, space, 64);
PIN_SIZE(plp_surface_counts, 64);
PIN_OFFSET(plp_surface_counts, watertight, 60);
PIN_SIZE(plp_model_info, 304);
PIN_OFFSET(plp_model_info, source, 8);
PIN_OFFSET(plp_model_info, searched, 72);
PIN_OFFSET(plp_model_info, stored_vertices, 136);
PIN_OFFSET(plp_model_info, bounds_min, 192);
PIN_OFFSET(plp_model_info, mesh_bytes, 248);
PIN_OFFSET(plp_model_info, tree_us, 280);
PIN_OFFSET(plp_model_info, read_bytes, 288);
PIN_OFFSET(plp_model_info, decoded_bytes, 296);
PIN_SIZE(plp_lmd, 144);
PIN_OFFSET(plp_lmd, distance, 72);
PIN_OFFSET(plp_lmd, force, 88);
PIN_OFFSET(plp_lmd, body_a, 112);
PIN_OFFSET(plp_lmd, set, 128);
PIN_OFFSET(plp_lmd, feature_a, 132);
PIN_OFFSET(plp_lmd, triangle_a, 136);
PIN_SIZE(plp_overlap, 24);
PIN_SIZE(plp_work, 88);
PIN_SIZE(plp_contacts, 248);
PIN_OFFSET(plp_contacts, lmds, 8);
PIN_OFFSET(plp_contacts, overlaps, 40);
PIN_OFFSET(plp_contacts, min_distance, 72);
PIN_OFFSET(plp_contacts, wrench, 80);
PIN_OFFSET(plp_contacts, search_us, 128);
PIN_OFFSET(plp_contacts, work, 136);
PIN_OFFSET(plp_contacts, springs, 224);
PIN_OFFSET(plp_contacts, status, 240);
PIN_SIZE(plp_query_options, 56);
PIN_OFFSET(plp_query_options, law, 48);
PIN_OFFSET(plp_query_options, reference_point, 24);
PIN_SIZE(plp_scene_options, 112);
PIN_OFFSET(plp_scene_options, law, 56);
PIN_OFFSET(plp_scene_options, threads, 60);
PIN_OFFSET(plp_scene_options, tick_budget, 104);
PIN_OFFSET(plp_scene_options, mode, 48);
PIN_OFFSET(plp_scene_options, damping, 64);
PIN_OFFSET(plp_scene_options, time_step, 96);
PIN_OFFSET(plp_scene_options, cutoff, 32);
PIN_SIZE(plp_body_options, 128);
PIN_OFFSET(plp_body_options, model, 8);
PIN_OFFSET(plp_body_options, pose, 16);
PIN_OFFSET(plp_body_options, reference_point, 80);
PIN_OFFSET(plp_body_options, intangible, 120);
PIN_SIZE(plp_device_info, 1232);
PIN_OFFSET(plp_device_info, condition, 712);
PIN_OFFSET(plp_device_info, status, 720);
PIN_SIZE(plp_device_state, 408);
PIN_OFFSET(plp_device_state, condition, 384);
PIN_OFFSET(plp_device_state, temperature, 392);
PIN_OFFSET(plp_device_state, lost, 400);
PIN_SIZE(plp_body_info, 312);
PIN_OFFSET(plp_body_info, name, 8);
PIN_OFFSET(plp_body_info, node, 264);
PIN_OFFSET(plp_body_info, above, 272);
PIN_OFFSET(plp_body_info, friction, 304);
PIN_SIZE(plp_gltf_scene_options, 88);
PIN_OFFSET(plp_gltf_scene_options, tool, 16);
PIN_OFFSET(plp_gltf_scene_options, pose, 24);
PIN_OFFSET(plp_gltf_scene_options, cutoff, 80);
PIN_SIZE(plp_servo_options, 24);
PIN_OFFSET(plp_servo_options, rate, 8);
PIN_OFFSET(plp_servo_options, priority, 16);
PIN_SIZE(plp_servo_state, 160);
PIN_OFFSET(plp_servo_state, wanted_rate, 16);
PIN_OFFSET(plp_servo_state, work_us, 56);
PIN_OFFSET(plp_servo_state, lateness_us, 88);
PIN_OFFSET(plp_servo_state, result_age, 152);
PIN_SIZE(plp_recording, 32);
PIN_SIZE(plp_trace_info, 48);
PIN_OFFSET(plp_trace_info, duration, 40);
PIN_SIZE(plp_trace_body, 112);
PIN_OFFSET(plp_trace_body, model_name, 16);
PIN_OFFSET(plp_trace_body, reference_point, 64);
PIN_OFFSET(plp_trace_body, end_tick, 96);
PIN_OFFSET(plp_trace_body, intangible, 104);
PIN_SIZE(plp_trace_move, 64);
PIN_SIZE(plp_trace_tick, 296);
PIN_OFFSET(plp_trace_tick, time, 24);
PIN_OFFSET(plp_trace_tick, mode, 88);
PIN_OFFSET(plp_trace_tick, tool_pose, 104);
PIN_OFFSET(plp_trace_tick, wrench, 160);
PIN_OFFSET(plp_trace_tick, step_us, 248);
PIN_OFFSET(plp_trace_tick, removed_count, 288);

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  failures += 1;
  fprintf(stderr, "does not hold: %s; last error: %s\n", what, plp_last_error());
}

static plp_model one_triangle(double x) {
  double positions[9];
  plp_triangles triangles;
  plp_model model = NULL;
  positions[0] = x, positions[1] = 0.0, positions[2] = 0.0;
  positions[3] = x, positions[4] = 1.0, positions[5] = 0.0;
  positions[6] = x, positions[7] = 0.0, positions[8] = 1.0;
  plp_triangles_init(&triangles, sizeof triangles);
  triangles.positions = positions;
  triangles.position_type = PLP_TYPE_FLOAT64;
  triangles.vertex_count = 3;
  expect(plp_model_create_from_triangles(&triangles, NULL, &model) == PLP_OK, "a triangle is a model");
  return model;
}

int main(void) {
  const plp_pose apart = {{0.25, 0.0, 0.0}, {0.0, 0.0, 0.0, 1.0}};
  plp_query_options options;
  plp_query_result result = NULL;
  plp_contacts contacts;
  plp_model model = one_triangle(0.0);

  expect(strcmp(plp_version_string(), "0.1.0") == 0 && plp_version() == 1000, "the versions agree");
  expect(plp_query_result_create(&result) == PLP_OK, "a result can be made");
  plp_query_options_init(&options, sizeof options);
  options.cutoff = 0.5;
  expect(plp_query(model, model, &apart, &options, result) == PLP_OK, "two triangles can be searched");
  plp_contacts_init(&contacts, sizeof contacts);
  expect(plp_query_result_get(result, &contacts) == PLP_OK, "the result can be read");
  expect(contacts.set_count == 1 && contacts.min_distance == 0.25, "parallel triangles are one LMD");
  expect(plp_query_result_release(result) == PLP_OK, "the result is released");
  expect(plp_model_release(model) == PLP_OK, "the model is released");
  expect(plp_model_release(model) == PLP_ERROR_INVALID_HANDLE, "a second release is refused");
  return failures != 0;
}
