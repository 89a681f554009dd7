/* SPDX-License-Identifier: MIT */
/* What one object of the script class PalpateScene has: a scene, the models that it loaded, perhaps a device,
 * and the newest outcome. */
#ifndef PALPATE_BINDINGS_GODOT_TOUCH_H
#define PALPATE_BINDINGS_GODOT_TOUCH_H

#include <palpate/palpate.h>

#include "godot.h"

enum { TOUCH_ERROR_SIZE = 512 };

typedef struct touch {
  plp_scene scene;
  plp_device device;
  plp_model* models;
  size_t model_count;
  plp_contacts contacts;
  char error[TOUCH_ERROR_SIZE];
} touch;

touch* touch_create(void);
void touch_destroy(touch* self);

/* Keeps the sentence, shows it in the engine's log, and gives back nil. */
gd_variant touch_fail(touch* self, const char* sentence);
/* The same with the library's sentence if the call failed; true if it did not. */
bool touch_succeeded(touch* self, plp_result result);

/* Takes over the reference to a model, which it gives back at the end. False without memory; then the model
 * is released. */
bool touch_keep_model(touch* self, plp_model model);

/* Forgets an outcome whose arrays are no longer there. */
void touch_forget_contacts(touch* self);

#endif /* PALPATE_BINDINGS_GODOT_TOUCH_H */
