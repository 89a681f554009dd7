/* SPDX-License-Identifier: MIT */
/* Between the engine's values and this library's. */
#ifndef PALPATE_BINDINGS_GODOT_VALUES_H
#define PALPATE_BINDINGS_GODOT_VALUES_H

#include <palpate/palpate.h>

#include "godot.h"

gd_variant variant_nil(void);
gd_variant variant_of_bool(bool value);
gd_variant variant_of_int(int64_t value);
gd_variant variant_of_real(double value);
gd_variant variant_of_text(const char* utf8);
gd_variant variant_of_vector(const double vector[3]);
gd_variant variant_of_pose(const plp_pose* pose);
/* An Array of floats, which GDScript keeps in double precision. */
gd_variant variant_of_numbers(const double* numbers, int count);

/* These two take over the value, and the array or dictionary is the caller's. */
void array_append(gd_handle* array, gd_variant value);
void dictionary_set(gd_handle* dictionary, const char* key, gd_variant value);
gd_variant variant_of_array(gd_handle* array);
gd_variant variant_of_dictionary(gd_handle* dictionary);

/* UTF-8 as long as it is held; text_release gives it back. */
gd_handle text_hold(const gd_variant* value);
const char* text_of(const gd_handle* held);
void text_release(gd_handle* held);

bool is_number(const gd_variant* value);

/* False if the transform scales, shears or mirrors, which no pose does. */
bool pose_of(const gd_variant* transform, plp_pose* pose);

/* False if the array does not hold just so many numbers. */
bool numbers_of(const gd_variant* array, double* numbers, int count);

#endif /* PALPATE_BINDINGS_GODOT_VALUES_H */
