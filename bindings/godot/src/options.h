/* SPDX-License-Identifier: MIT */
/* Options from a Dictionary. */
#ifndef PALPATE_BINDINGS_GODOT_OPTIONS_H
#define PALPATE_BINDINGS_GODOT_OPTIONS_H

#include <palpate/palpate.h>

#include "godot.h"

/* The defaults, and what the Dictionary says: false with a sentence, of at most `size` bytes, about the first
 * entry that is no option or has a wrong value. */
bool scene_options_of(const gd_variant* dictionary, plp_scene_options* options, char* sentence, size_t size);
bool model_options_of(const gd_variant* dictionary, plp_model_options* options, char* sentence, size_t size);

#endif /* PALPATE_BINDINGS_GODOT_OPTIONS_H */
