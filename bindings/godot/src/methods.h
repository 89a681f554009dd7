/* SPDX-License-Identifier: MIT */
/* The methods of the script class PalpateScene. */
#ifndef PALPATE_BINDINGS_GODOT_METHODS_H
#define PALPATE_BINDINGS_GODOT_METHODS_H

#include "touch.h"

/* One letter for each argument: i an int, n a number, s a String, t a Transform, a an Array, d a
 * Dictionary; those behind | may be left out. */
typedef struct method {
  const char* name;
  const char* arguments;
  gd_variant (*call)(touch* self, int count, gd_variant** arguments);
} method;

extern const method kMethods[];
extern const int kMethodCount;

#endif /* PALPATE_BINDINGS_GODOT_METHODS_H */
