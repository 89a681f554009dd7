/* SPDX-License-Identifier: MIT */
/* What the engine looks for in this library: it begins, tells the classes that it adds, and ends. */
#include <stdio.h>
#include <string.h>

#include "methods.h"
#include "values.h"

const gd_core* gd;

#define GD_EXPORT __attribute__((visibility("default")))
void godot_gdnative_init(gd_init_options* options);
void godot_gdnative_terminate(void* options);
void godot_nativescript_init(void* handle);

static const gd_nativescript* nativescript;

static const gd_nativescript* find_nativescript(const gd_core* core) {
  for (unsigned i = 0; i < core->extension_count; ++i) {
    const gd_table* table = core->extensions[i];
    if (table->type == GD_TABLE_NATIVESCRIPT && table->version.major == 1)
      return (const gd_nativescript*)table;
  }
  return NULL;
}

GD_EXPORT void godot_gdnative_init(gd_init_options* options) {
  const gd_core* core = options->core;
  if (core->head.type != GD_TABLE_CORE || core->head.version.major != 1 || !find_nativescript(core)) {
    options->report_loading_error(options->library, "Palpate is for Godot 3: GDNative 1 with NativeScript 1");
    return;
  }
  gd = core;
  nativescript = find_nativescript(core);
}

GD_EXPORT void godot_gdnative_terminate(void* options) {
  (void)options;
  plp_shutdown_all();
  gd = NULL;
  nativescript = NULL;
}

static void* create_instance(gd_object* object, void* data) {
  (void)object, (void)data;
  return touch_create();
}

static void destroy_instance(gd_object* object, void* data, void* instance) {
  (void)object, (void)data;
  touch_destroy(instance);
}

static bool fits(char letter, const gd_variant* argument) {
  const int type = gd_variant_type(argument);
  switch (letter) {
    case 'i':
      return type == GD_INT;
    case 'n':
      return type == GD_INT || type == GD_REAL;
    case 's':
      return type == GD_STRING;
    case 't':
      return type == GD_TRANSFORM;
    case 'a':
      return type == GD_ARRAY || type == GD_POOL_REAL;
    default:
      return type == GD_DICTIONARY;
  }
}

static bool arguments_fit(const char* letters, int count, gd_variant** arguments) {
  const char* optional = strchr(letters, '|');
  const int total = (int)strlen(letters) - (optional != NULL);
  const int required = optional ? (int)(optional - letters) : total;
  if (count < required || count > total) return false;
  for (int i = 0; i < count; ++i)
    if (!fits(letters[i + (optional && i >= required)], arguments[i])) return false;
  return true;
}

static gd_variant call(gd_object* object, void* data, void* instance, int count, gd_variant** arguments) {
  (void)object;
  const method* called = data;
  touch* self = instance;
  if (!self) return variant_nil();
  if (arguments_fit(called->arguments, count, arguments)) return called->call(self, count, arguments);
  char sentence[TOUCH_ERROR_SIZE];
  snprintf(sentence, sizeof sentence, "%s: the arguments are not what it takes", called->name);
  return touch_fail(self, sentence);
}

typedef void (*register_class)(void* handle, const char* name, const char* base, gd_create, gd_destroy);
typedef void (*register_method)(void* handle, const char* name, const char* method, gd_method_attributes,
                                gd_method);
enum { kRegisterClass = 0, kRegisterMethod = 2 };

GD_EXPORT void godot_nativescript_init(void* handle) {
  static const char kName[] = "PalpateScene";
  if (!nativescript) return;
  const gd_create creating = {create_instance, NULL, NULL};
  const gd_destroy destroying = {destroy_instance, NULL, NULL};
  ((register_class)nativescript->functions[kRegisterClass])(handle, kName, "Reference", creating, destroying);
  for (int i = 0; i < kMethodCount; ++i) {
    const gd_method_attributes attributes = {0};
    const gd_method calling = {call, (void*)&kMethods[i], NULL};
    ((register_method)nativescript->functions[kRegisterMethod])(handle, kName, kMethods[i].name, attributes,
                                                                calling);
  }
}
