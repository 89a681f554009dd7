/* reference FOLDER FILE: what C gets from the library, bit for bit, for other languages to compare with.

   The file is a sequence of 8-byte numbers: doubles, and counts as uint64. First the queries: how many, then
   for each its pose (7), lmd_count, set_count, min_distance, wrench (6) and for each LMD its points, normal,
   distance, weight and force (14). Then for each of the three modes: how many ticks, then for each its pose
   (7), set_count, min_distance and wrench (6). */
#include <palpate/palpate.h>
#include <stdio.h>
#include <stdlib.h>

#define CUTOFF 0.05
static FILE* file;

static void fail(const char* what) {
  fprintf(stderr, "reference: %s\n", what);
  exit(1);
}

static void check(plp_result result) {
  if (result < 0) fail(plp_last_error());
}

static void write_doubles(const double* numbers, size_t count) {
  if (fwrite(numbers, sizeof *numbers, count, file) != count) fail("cannot write");
}

static void write_count(uint64_t count) {
  if (fwrite(&count, sizeof count, 1, file) != 1) fail("cannot write");
}

static void write_pose(const plp_pose* pose) {
  write_doubles(pose->position, 3);
  write_doubles(pose->orientation, 4);
}

static void write_wrench(const plp_wrench* wrench) {
  write_doubles(wrench->force, 3);
  write_doubles(wrench->torque, 3);
}

/* To and fro between 0 and 1. */
static double swing(uint64_t tick, uint64_t period) {
  const double phase = (double)(tick % period) / (double)period;
  return phase < 0.5 ? 2 * phase : 2 - 2 * phase;
}

/* The tool slides over the body, into reach and out of it, and turns. Periods without a common divisor. */
static plp_pose pose_at(uint64_t tick, double distance) {
  plp_pose pose;
  pose.position[0] = distance * (0.85 + 0.3 * swing(tick, 1999));
  pose.position[1] = distance * (0.2 * swing(tick, 1511) - 0.1);
  pose.position[2] = distance * (0.2 * swing(tick, 1123) - 0.1);
  pose.orientation[0] = 0.4 * swing(tick, 2503);
  pose.orientation[1] = 0.3 * swing(tick, 1777) - 0.15;
  pose.orientation[2] = 0.2;
  pose.orientation[3] = 1;
  return pose;
}

static plp_model load(const char* folder, const char* name) {
  char path[4096];
  plp_model model;
  if (snprintf(path, sizeof path, "%s/%s", folder, name) >= (int)sizeof path)
    fail("the folder's name is too long");
  check(plp_model_load_file(path, NULL, &model));
  return model;
}

static double diagonal(plp_model model) {
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  check(plp_model_get_info(model, &info));
  return info.diagonal;
}

static void write_lmds(const plp_contacts* contacts) {
  for (size_t i = 0; i < contacts->lmd_count; ++i) {
    const plp_lmd* lmd = (const plp_lmd*)((const char*)contacts->lmds + i * contacts->lmd_stride);
    write_doubles(lmd->point_a, 3);
    write_doubles(lmd->point_b, 3);
    write_doubles(lmd->normal, 3);
    write_doubles(&lmd->distance, 1);
    write_doubles(&lmd->weight, 1);
    write_doubles(lmd->force, 3);
  }
}

static void query(plp_model body, plp_model tool, uint64_t count, double distance) {
  plp_query_options options;
  plp_query_result result;
  plp_query_options_init(&options, sizeof options);
  options.cutoff = CUTOFF * distance;
  check(plp_query_result_create(&result));
  write_count(count);
  for (uint64_t i = 0; i < count; ++i) {
    const plp_pose pose = pose_at(97 * i, distance);
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    check(plp_query(body, tool, &pose, &options, result));
    check(plp_query_result_get(result, &contacts));
    write_pose(&pose);
    write_count(contacts.lmd_count);
    write_count(contacts.set_count);
    write_doubles(&contacts.min_distance, 1);
    write_wrench(&contacts.wrench);
    write_lmds(&contacts);
  }
  check(plp_query_result_release(result));
}

static plp_body add(plp_scene scene, plp_model model, plp_body_kind kind) {
  plp_body_options options;
  plp_body body;
  plp_body_options_init(&options, sizeof options);
  options.model = model;
  options.kind = kind;
  check(plp_scene_add_body(scene, &options, &body));
  return body;
}

static void step(plp_model body, plp_model tool, plp_mode mode, uint64_t count, double distance) {
  plp_scene_options options;
  plp_scene scene;
  plp_body held;
  plp_scene_options_init(&options, sizeof options);
  options.cutoff = CUTOFF * distance;
  options.mode = mode;
  check(plp_scene_create(&options, &scene));
  add(scene, body, PLP_BODY_STATIC);
  held = add(scene, tool, PLP_BODY_TOOL);
  write_count(count);
  for (uint64_t i = 0; i < count; ++i) {
    const plp_pose pose = pose_at(i, distance);
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    check(plp_scene_set_pose(scene, held, &pose));
    check(plp_scene_step(scene));
    check(plp_scene_get_contacts(scene, &contacts));
    write_pose(&pose);
    write_count(contacts.set_count);
    write_doubles(&contacts.min_distance, 1);
    write_wrench(&contacts.wrench);
  }
  check(plp_scene_release(scene));
}

int main(int argc, char** argv) {
  if (argc != 3) fail("usage: reference FOLDER FILE");
  file = fopen(argv[2], "wb");
  if (!file) fail("cannot open the file");
  plp_model body = load(argv[1], "torus.glb"), tool = load(argv[1], "organic_2200.glb");
  const double distance = 0.5 * (diagonal(body) + diagonal(tool)) * 0.7;
  write_doubles(&distance, 1);
  query(body, tool, 30, distance);
  step(body, tool, PLP_MODE_GLOBAL, 1000, distance);
  step(body, tool, PLP_MODE_DESCENT, 3000, distance);
  step(body, tool, PLP_MODE_CERTIFIED, 10000, distance);
  check(plp_model_release(tool));
  check(plp_model_release(body));
  if (fclose(file) != 0) fail("cannot write");
  return 0;
}
