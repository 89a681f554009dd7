/* SPDX-License-Identifier: MIT */
/* What this plug-in needs of Godot 3's native interface (GDNative core 1.0, NativeScript 1.0, both with
 * 64-bit pointers), so that it is built without Godot's headers. The engine hands over tables of functions
 * whose order never changes within a major version; a place in the table is named here once. */
#ifndef PALPATE_BINDINGS_GODOT_GODOT_H
#define PALPATE_BINDINGS_GODOT_GODOT_H

#include <stdbool.h>
#include <stdint.h>

/* The engine's values. They are bytes to the caller, so that all are passed as integers. */
typedef struct gd_variant {
  uint8_t bytes[24];
} gd_variant;
typedef struct gd_vector3 {
  uint8_t bytes[12]; /* three floats */
} gd_vector3;
typedef struct gd_transform {
  uint8_t bytes[48]; /* three rows of a matrix, then the origin: floats */
} gd_transform;
typedef struct gd_handle { /* a String, Array, Dictionary or pool array */
  uint8_t bytes[8];
} gd_handle;
typedef struct gd_object gd_object;

enum gd_type {
  GD_NIL = 0,
  GD_BOOL = 1,
  GD_INT = 2,
  GD_REAL = 3,
  GD_STRING = 4,
  GD_TRANSFORM = 13,
  GD_DICTIONARY = 18,
  GD_ARRAY = 19,
  GD_POOL_INT = 21,
  GD_POOL_REAL = 22,
  GD_POOL_VECTOR3 = 25
};

typedef void (*gd_function)(void);

enum { GD_CORE_FUNCTIONS = 744, GD_NATIVESCRIPT_FUNCTIONS = 6 };

typedef struct gd_version {
  unsigned major;
  unsigned minor;
} gd_version;

/* How every table begins. */
typedef struct gd_table {
  unsigned type;
  gd_version version;
  const struct gd_table* next;
} gd_table;

typedef struct gd_core {
  gd_table head;
  unsigned extension_count;
  const gd_table* const* extensions;
  gd_function functions[GD_CORE_FUNCTIONS];
} gd_core;

enum { GD_TABLE_CORE = 0, GD_TABLE_NATIVESCRIPT = 1 };

typedef struct gd_nativescript {
  gd_table head;
  gd_function functions[GD_NATIVESCRIPT_FUNCTIONS];
} gd_nativescript;

typedef struct gd_init_options {
  bool in_editor;
  uint64_t hashes[3];
  void (*report_version_mismatch)(const gd_object* library, const char* what, gd_version want,
                                  gd_version have);
  void (*report_loading_error)(const gd_object* library, const char* what);
  gd_object* library;
  const gd_core* core;
  const gd_handle* library_path;
} gd_init_options;

typedef struct gd_create {
  void* (*function)(gd_object*, void* data);
  void* data;
  void (*free_data)(void* data);
} gd_create;
typedef struct gd_destroy {
  void (*function)(gd_object*, void* data, void* instance);
  void* data;
  void (*free_data)(void* data);
} gd_destroy;
typedef struct gd_method {
  gd_variant (*function)(gd_object*, void* data, void* instance, int count, gd_variant** arguments);
  void* data;
  void (*free_data)(void* data);
} gd_method;
typedef struct gd_method_attributes {
  int rpc; /* 0: none */
} gd_method_attributes;

/* Of the one engine that loaded this library; null before and after. */
extern const gd_core* gd;

/* GD(place, type of what is returned, types of the arguments). */
#define GD(place, result, ...) ((result(*)(__VA_ARGS__))gd->functions[place])

#define gd_pool_int_read GD(181, void*, const gd_handle*)
#define gd_pool_int_size GD(185, int, const gd_handle*)
#define gd_pool_int_destroy GD(186, void, gd_handle*)
#define gd_pool_vector3_read GD(245, void*, const gd_handle*)
#define gd_pool_vector3_size GD(249, int, const gd_handle*)
#define gd_pool_vector3_destroy GD(250, void, gd_handle*)
#define gd_pool_int_read_pointer GD(272, const int32_t*, const void*)
#define gd_pool_int_read_destroy GD(274, void, void*)
#define gd_pool_vector3_read_pointer GD(288, const float*, const void*)
#define gd_pool_vector3_read_destroy GD(290, void, void*)
#define gd_array_new GD(323, void, gd_handle*)
#define gd_array_get GD(333, gd_variant, const gd_handle*, int)
#define gd_array_append GD(336, void, gd_handle*, const gd_variant*)
#define gd_array_size GD(356, int, const gd_handle*)
#define gd_array_destroy GD(361, void, gd_handle*)
#define gd_dictionary_new GD(362, void, gd_handle*)
#define gd_dictionary_destroy GD(364, void, gd_handle*)
#define gd_dictionary_keys GD(372, gd_handle, const gd_handle*)
#define gd_dictionary_get GD(374, gd_variant, const gd_handle*, const gd_variant*)
#define gd_dictionary_set GD(375, void, gd_handle*, const gd_variant*, const gd_variant*)
#define gd_variant_type GD(507, int, const gd_variant*)
#define gd_variant_new_nil GD(509, void, gd_variant*)
#define gd_variant_new_bool GD(510, void, gd_variant*, bool)
#define gd_variant_new_int GD(512, void, gd_variant*, int64_t)
#define gd_variant_new_real GD(513, void, gd_variant*, double)
#define gd_variant_new_string GD(514, void, gd_variant*, const gd_handle*)
#define gd_variant_new_vector3 GD(517, void, gd_variant*, const gd_vector3*)
#define gd_variant_new_transform GD(523, void, gd_variant*, const gd_transform*)
#define gd_variant_new_dictionary GD(528, void, gd_variant*, const gd_handle*)
#define gd_variant_new_array GD(529, void, gd_variant*, const gd_handle*)
#define gd_variant_as_bool GD(537, bool, const gd_variant*)
#define gd_variant_as_int GD(539, int64_t, const gd_variant*)
#define gd_variant_as_real GD(540, double, const gd_variant*)
#define gd_variant_as_string GD(541, gd_handle, const gd_variant*)
#define gd_variant_as_transform GD(550, gd_transform, const gd_variant*)
#define gd_variant_as_dictionary GD(555, gd_handle, const gd_variant*)
#define gd_variant_as_array GD(556, gd_handle, const gd_variant*)
#define gd_variant_as_pool_int GD(558, gd_handle, const gd_variant*)
#define gd_variant_as_pool_vector3 GD(562, gd_handle, const gd_variant*)
#define gd_variant_destroy GD(570, void, gd_variant*)
#define gd_utf8_data GD(572, const char*, const gd_handle*)
#define gd_utf8_destroy GD(573, void, gd_handle*)
#define gd_string_utf8 GD(678, gd_handle, const gd_handle*)
#define gd_string_from_utf8 GD(681, gd_handle, const char*)
#define gd_string_destroy GD(721, void, gd_handle*)
#define gd_print_error GD(741, void, const char*, const char*, const char*, int)

#endif /* PALPATE_BINDINGS_GODOT_GODOT_H */
