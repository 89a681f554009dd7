/* SPDX-License-Identifier: MIT */
#include "methods.h"

#include <string.h>

#include "mesh_arrays.h"
#include "options.h"
#include "values.h"

/* -------------------------------------------------------------------------------------------------- scene */

static gd_variant create(touch* self, int count, gd_variant** arguments) {
  (void)count;
  plp_scene_options options;
  char sentence[TOUCH_ERROR_SIZE];
  if (!scene_options_of(arguments[0], &options, sentence, sizeof sentence)) {
    touch_fail(self, sentence);
    return variant_of_bool(false);
  }
  plp_scene scene;
  if (!touch_succeeded(self, plp_scene_create(&options, &scene))) return variant_of_bool(false);
  plp_scene_release(self->scene);
  self->scene = scene;
  touch_forget_contacts(self);
  return variant_of_bool(true);
}

static gd_variant last_error(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_text(self->error);
}

static gd_variant number_of_model(touch* self, plp_model model) {
  if (touch_keep_model(self, model)) return variant_of_int((int64_t)(intptr_t)model);
  touch_fail(self, "out of memory");
  return variant_of_int(0);
}

/* The defaults if none are given. */
static bool read_model_options(touch* self, int count, gd_variant** arguments, plp_model_options* options) {
  char sentence[TOUCH_ERROR_SIZE];
  plp_model_options_init(options, sizeof *options);
  if (count < 2 || model_options_of(arguments[1], options, sentence, sizeof sentence)) return true;
  touch_fail(self, sentence);
  return false;
}

static gd_variant load_model(touch* self, int count, gd_variant** arguments) {
  plp_model_options options;
  if (!read_model_options(self, count, arguments, &options)) return variant_of_int(0);
  gd_handle path = text_hold(arguments[0]);
  plp_model model;
  const plp_result result = plp_model_load_file(text_of(&path), &options, &model);
  text_release(&path);
  return touch_succeeded(self, result) ? number_of_model(self, model) : variant_of_int(0);
}

static gd_variant model_from_arrays(touch* self, int count, gd_variant** arguments) {
  plp_model_options options;
  if (!read_model_options(self, count, arguments, &options)) return variant_of_int(0);
  plp_model model;
  const plp_result result = model_from_mesh_arrays(arguments[0], &options, &model);
  return touch_succeeded(self, result) ? number_of_model(self, model) : variant_of_int(0);
}

/* --------------------------------------------------------------------------------------------------- bodies
 */

static plp_body body_of(const gd_variant* number) {
  return (plp_body)gd_variant_as_int(number);
}

static bool rigid_pose(touch* self, const gd_variant* transform, plp_pose* pose) {
  if (pose_of(transform, pose)) return true;
  touch_fail(self, "the Transform scales, shears or mirrors, or is not finite: a pose only turns and moves");
  return false;
}

static bool kind_of(touch* self, const gd_variant* name, plp_body_kind* kind) {
  static const char* const kKinds[] = {"static", "moving", "tool"};
  gd_handle held = text_hold(name);
  int found = -1;
  for (int i = 0; i < 3; ++i)
    if (strcmp(text_of(&held), kKinds[i]) == 0) found = i;
  text_release(&held);
  if (found < 0) touch_fail(self, "a body is \"static\", \"moving\" or \"tool\"");
  *kind = (plp_body_kind)found;
  return found >= 0;
}

static gd_variant add_body(touch* self, int count, gd_variant** arguments) {
  plp_body_options options;
  plp_body_options_init(&options, sizeof options);
  options.model = (plp_model)(intptr_t)gd_variant_as_int(arguments[0]);
  plp_body body = 0;
  if (!kind_of(self, arguments[1], &options.kind)) return variant_of_int(0);
  if (count > 2 && !rigid_pose(self, arguments[2], &options.pose)) return variant_of_int(0);
  return variant_of_int(
      touch_succeeded(self, plp_scene_add_body(self->scene, &options, &body)) ? (int64_t)body : 0);
}

static gd_variant remove_body(touch* self, int count, gd_variant** arguments) {
  (void)count;
  return variant_of_bool(touch_succeeded(self, plp_scene_remove_body(self->scene, body_of(arguments[0]))));
}

static gd_variant set_pose(touch* self, int count, gd_variant** arguments) {
  (void)count;
  plp_pose pose;
  return variant_of_bool(
      rigid_pose(self, arguments[1], &pose) &&
      touch_succeeded(self, plp_scene_set_pose(self->scene, body_of(arguments[0]), &pose)));
}

static gd_variant set_exact_pose(touch* self, int count, gd_variant** arguments) {
  (void)count;
  double numbers[7];
  if (!numbers_of(arguments[1], numbers, 7)) {
    touch_fail(self, "a pose has seven numbers: its position and its quaternion x y z w");
    return variant_of_bool(false);
  }
  plp_pose pose;
  memcpy(pose.position, numbers, sizeof pose.position);
  memcpy(pose.orientation, numbers + 3, sizeof pose.orientation);
  return variant_of_bool(
      touch_succeeded(self, plp_scene_set_pose(self->scene, body_of(arguments[0]), &pose)));
}

static gd_variant get_pose(touch* self, int count, gd_variant** arguments) {
  (void)count;
  plp_pose pose;
  if (!touch_succeeded(self, plp_scene_get_pose(self->scene, body_of(arguments[0]), &pose)))
    return variant_nil();
  return variant_of_pose(&pose);
}

/* -------------------------------------------------------------------------------------------------- outcome
 */

static bool read_contacts(touch* self) {
  touch_forget_contacts(self);
  if (touch_succeeded(self, plp_scene_get_contacts(self->scene, &self->contacts))) return true;
  touch_forget_contacts(self);
  return false;
}

static gd_variant step(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_bool(touch_succeeded(self, plp_scene_step(self->scene)) && read_contacts(self));
}

static gd_variant start(touch* self, int count, gd_variant** arguments) {
  plp_servo_options options;
  plp_servo_options_init(&options, sizeof options);
  if (count > 0) options.rate = gd_variant_as_real(arguments[0]);
  return variant_of_bool(touch_succeeded(self, plp_scene_start(self->scene, &options)));
}

static gd_variant stop(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_bool(touch_succeeded(self, plp_scene_stop(self->scene)));
}

static gd_variant poll(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_bool(read_contacts(self));
}

static gd_variant get_force(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_vector(self->contacts.wrench.force);
}

static gd_variant get_torque(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_vector(self->contacts.wrench.torque);
}

static gd_variant get_exact_wrench(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  double numbers[6];
  memcpy(numbers, self->contacts.wrench.force, 3 * sizeof *numbers);
  memcpy(numbers + 3, self->contacts.wrench.torque, 3 * sizeof *numbers);
  return variant_of_numbers(numbers, 6);
}

static gd_variant get_min_distance(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_real(self->contacts.min_distance);
}

static gd_variant is_overlapping(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_bool(self->contacts.overlap != 0);
}

static gd_variant get_set_count(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_int((int64_t)self->contacts.set_count);
}

static gd_variant contact_of(const plp_lmd* lmd) {
  gd_handle contact;
  gd_dictionary_new(&contact);
  dictionary_set(&contact, "point_a", variant_of_vector(lmd->point_a));
  dictionary_set(&contact, "point_b", variant_of_vector(lmd->point_b));
  dictionary_set(&contact, "normal", variant_of_vector(lmd->normal));
  dictionary_set(&contact, "distance", variant_of_real(lmd->distance));
  dictionary_set(&contact, "force", variant_of_vector(lmd->force));
  dictionary_set(&contact, "body_a", variant_of_int((int64_t)lmd->body_a));
  dictionary_set(&contact, "body_b", variant_of_int((int64_t)lmd->body_b));
  dictionary_set(&contact, "set", variant_of_int(lmd->set));
  return variant_of_dictionary(&contact);
}

static gd_variant get_contacts(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  gd_handle contacts;
  gd_array_new(&contacts);
  const char* lmd = (const char*)self->contacts.lmds;
  for (size_t i = 0; i < self->contacts.lmd_count; ++i, lmd += self->contacts.lmd_stride)
    array_append(&contacts, contact_of((const plp_lmd*)lmd));
  return variant_of_array(&contacts);
}

/* --------------------------------------------------------------------------------------------------- device
 */

static gd_variant open_device(touch* self, int count, gd_variant** arguments) {
  (void)count;
  gd_handle uri = text_hold(arguments[0]);
  plp_device device;
  bool opened = touch_succeeded(self, plp_device_open(text_of(&uri), &device));
  text_release(&uri);
  if (!opened) return variant_of_bool(false);
  opened = touch_succeeded(self, plp_scene_set_device(self->scene, device, NULL));
  plp_device_release(opened ? self->device : device);
  if (opened) self->device = device;
  return variant_of_bool(opened);
}

static gd_variant close_device(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  const bool closed = touch_succeeded(self, plp_scene_set_device(self->scene, NULL, NULL));
  plp_device_release(self->device);
  self->device = NULL;
  return variant_of_bool(closed);
}

static gd_variant arm_device(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_bool(touch_succeeded(self, plp_device_arm(self->device)));
}

static gd_variant disarm_device(touch* self, int count, gd_variant** arguments) {
  (void)count, (void)arguments;
  return variant_of_bool(touch_succeeded(self, plp_device_disarm(self->device)));
}

const method kMethods[] = {
    {"create", "d", create},
    {"last_error", "", last_error},
    {"load_model", "s|d", load_model},
    {"model_from_arrays", "a|d", model_from_arrays},
    {"add_body", "is|t", add_body},
    {"remove_body", "i", remove_body},
    {"set_pose", "it", set_pose},
    {"set_exact_pose", "ia", set_exact_pose},
    {"get_pose", "i", get_pose},
    {"step", "", step},
    {"start", "|n", start},
    {"stop", "", stop},
    {"poll", "", poll},
    {"get_force", "", get_force},
    {"get_torque", "", get_torque},
    {"get_exact_wrench", "", get_exact_wrench},
    {"get_min_distance", "", get_min_distance},
    {"is_overlapping", "", is_overlapping},
    {"get_set_count", "", get_set_count},
    {"get_contacts", "", get_contacts},
    {"open_device", "s", open_device},
    {"close_device", "", close_device},
    {"arm_device", "", arm_device},
    {"disarm_device", "", disarm_device},
};
const int kMethodCount = sizeof kMethods / sizeof *kMethods;
