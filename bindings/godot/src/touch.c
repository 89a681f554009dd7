/* SPDX-License-Identifier: MIT */
#include "touch.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "values.h"

touch* touch_create(void) {
  touch* self = calloc(1, sizeof *self);
  if (self) touch_forget_contacts(self);
  return self;
}

void touch_destroy(touch* self) {
  if (!self) return;
  plp_scene_release(self->scene);
  plp_device_release(self->device);
  for (size_t i = 0; i < self->model_count; ++i) plp_model_release(self->models[i]);
  free(self->models);
  free(self);
}

gd_variant touch_fail(touch* self, const char* sentence) {
  snprintf(self->error, sizeof self->error, "%s", sentence);
  gd_print_error(self->error, "PalpateScene", "palpate", 0);
  return variant_nil();
}

bool touch_succeeded(touch* self, plp_result result) {
  if (result >= 0) return true;
  touch_fail(self, plp_last_error());
  return false;
}

bool touch_keep_model(touch* self, plp_model model) {
  plp_model* grown = realloc(self->models, (self->model_count + 1) * sizeof *grown);
  if (!grown) {
    plp_model_release(model);
    return false;
  }
  self->models = grown;
  self->models[self->model_count++] = model;
  return true;
}

void touch_forget_contacts(touch* self) {
  plp_contacts_init(&self->contacts, sizeof self->contacts);
  self->contacts.min_distance = INFINITY;
}
