/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <stdio.h>
#include <string.h>

#include "values.h"

/* Of a scene. */
typedef struct number_option {
  const char* name;
  size_t offset; /* of a double */
} number_option;

static const number_option kNumbers[] = {
    {"cutoff", offsetof(plp_scene_options, cutoff)},
    {"stiffness", offsetof(plp_scene_options, stiffness)},
    {"damping", offsetof(plp_scene_options, damping)},
    {"stiffness_cap", offsetof(plp_scene_options, stiffness_cap)},
    {"friction", offsetof(plp_scene_options, friction)},
    {"fade_time", offsetof(plp_scene_options, fade_time)},
    {"time_step", offsetof(plp_scene_options, time_step)},
    {"metres_per_unit", offsetof(plp_scene_options, space) + offsetof(plp_space, metres_per_unit)},
};

typedef struct named_value {
  const char* option;
  const char* name;
  size_t offset; /* of an int32_t */
  int32_t value;
} named_value;

static const named_value kNames[] = {
    {"mode", "global", offsetof(plp_scene_options, mode), PLP_MODE_GLOBAL},
    {"mode", "descent", offsetof(plp_scene_options, mode), PLP_MODE_DESCENT},
    {"mode", "certified", offsetof(plp_scene_options, mode), PLP_MODE_CERTIFIED},
    {"law", "springs", offsetof(plp_scene_options, law), PLP_LAW_SPRINGS},
    {"law", "smooth", offsetof(plp_scene_options, law), PLP_LAW_SMOOTH},
};

enum { kNumberCount = sizeof kNumbers / sizeof *kNumbers, kNameCount = sizeof kNames / sizeof *kNames };

/* Each takes one entry; false if it knows none of that name and type. */
typedef bool (*setter)(void* options, const char* key, const gd_variant* value);

static bool set_number(void* options, const char* key, const gd_variant* value) {
  if (!is_number(value)) return false;
  for (int i = 0; i < kNumberCount; ++i)
    if (strcmp(key, kNumbers[i].name) == 0) {
      const double number = gd_variant_as_real(value);
      memcpy((char*)options + kNumbers[i].offset, &number, sizeof number);
      return true;
    }
  return false;
}

static bool set_name(void* options, const char* key, const gd_variant* value) {
  if (gd_variant_type(value) != GD_STRING) return false;
  gd_handle name = text_hold(value);
  bool found = false;
  for (int i = 0; i < kNameCount; ++i)
    if (strcmp(key, kNames[i].option) == 0 && strcmp(text_of(&name), kNames[i].name) == 0) {
      memcpy((char*)options + kNames[i].offset, &kNames[i].value, sizeof kNames[i].value);
      found = true;
    }
  text_release(&name);
  return found;
}

static bool set_scene_option(void* options, const char* key, const gd_variant* value) {
  return set_number(options, key, value) || set_name(options, key, value);
}

static bool set_model_option(void* options, const char* key, const gd_variant* value) {
  plp_model_options* model = options;
  if (strcmp(key, "scale") == 0 && is_number(value)) {
    model->scale = gd_variant_as_real(value);
    return true;
  }
  const uint32_t flag = strcmp(key, "double_sided") == 0   ? PLP_MODEL_DOUBLE_SIDED
                        : strcmp(key, "keep_winding") == 0 ? PLP_MODEL_KEEP_WINDING
                                                           : 0;
  if (flag == 0 || gd_variant_type(value) != GD_BOOL) return false;
  if (gd_variant_as_bool(value)) model->flags |= flag;
  return true;
}

static bool set_entry(const gd_handle* dictionary, const gd_variant* key, setter set, void* options,
                      char* sentence, size_t size) {
  gd_variant value = gd_dictionary_get(dictionary, key);
  gd_handle name = text_hold(key);
  const bool known = set(options, text_of(&name), &value);
  if (!known) {
    gd_handle given = text_hold(&value);
    snprintf(sentence, size, "%s: %s is no option here", text_of(&name), text_of(&given));
    text_release(&given);
  }
  text_release(&name);
  gd_variant_destroy(&value);
  return known;
}

static bool set_entries(const gd_variant* dictionary, setter set, void* options, char* sentence,
                        size_t size) {
  gd_handle held = gd_variant_as_dictionary(dictionary);
  gd_handle keys = gd_dictionary_keys(&held);
  bool all = true;
  for (int i = 0; all && i < gd_array_size(&keys); ++i) {
    gd_variant key = gd_array_get(&keys, i);
    all = set_entry(&held, &key, set, options, sentence, size);
    gd_variant_destroy(&key);
  }
  gd_array_destroy(&keys);
  gd_dictionary_destroy(&held);
  return all;
}

bool scene_options_of(const gd_variant* dictionary, plp_scene_options* options, char* sentence, size_t size) {
  plp_scene_options_init(options, sizeof *options);
  return set_entries(dictionary, set_scene_option, options, sentence, size);
}

bool model_options_of(const gd_variant* dictionary, plp_model_options* options, char* sentence, size_t size) {
  plp_model_options_init(options, sizeof *options);
  return set_entries(dictionary, set_model_option, options, sentence, size);
}
