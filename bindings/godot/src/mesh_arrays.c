/* SPDX-License-Identifier: MIT */
#include "mesh_arrays.h"

#include <stdlib.h>

#include "values.h"

enum { kArrayVertex = 0, kArrayIndex = 8 }; /* Mesh.ARRAY_VERTEX, Mesh.ARRAY_INDEX */

/* Three for each triangle, with the last two exchanged: Godot's triangles run clockwise seen from outside. */
static uint32_t* turned_indices(const gd_variant* indices, int vertex_count, size_t* triangle_count) {
  gd_handle held = gd_variant_as_pool_int(indices);
  const bool given = gd_variant_type(indices) == GD_POOL_INT && gd_pool_int_size(&held) > 0;
  const size_t count = (size_t)(given ? gd_pool_int_size(&held) : vertex_count) / 3;
  uint32_t* turned = malloc((3 * count + 1) * sizeof *turned);
  void* access = given ? gd_pool_int_read(&held) : NULL;
  const int32_t* read = given ? gd_pool_int_read_pointer(access) : NULL;
  for (size_t i = 0; turned && i < 3 * count; ++i) {
    const size_t from = i % 3 == 0 ? i : i % 3 == 1 ? i + 1 : i - 1;
    turned[i] = read ? (uint32_t)read[from] : (uint32_t)from;
  }
  if (access) gd_pool_int_read_destroy(access);
  gd_pool_int_destroy(&held);
  *triangle_count = count;
  return turned;
}

static plp_result create(const gd_handle* vertices, const gd_variant* indices,
                         const plp_model_options* options, plp_model* model) {
  plp_triangles triangles;
  plp_triangles_init(&triangles, sizeof triangles);
  triangles.vertex_count = (size_t)gd_pool_vector3_size(vertices);
  uint32_t* turned = turned_indices(indices, (int)triangles.vertex_count, &triangles.triangle_count);
  if (!turned) return PLP_ERROR_OUT_OF_MEMORY;
  void* access = gd_pool_vector3_read(vertices);
  triangles.positions = gd_pool_vector3_read_pointer(access);
  triangles.indices = turned;
  const plp_result result = plp_model_create_from_triangles(&triangles, options, model);
  gd_pool_vector3_read_destroy(access);
  free(turned);
  return result;
}

/* Nil if there is none. */
static gd_variant item_of(const gd_handle* array, int place) {
  return place < gd_array_size(array) ? gd_array_get(array, place) : variant_nil();
}

plp_result model_from_mesh_arrays(const gd_variant* arrays, const plp_model_options* options,
                                  plp_model* model) {
  gd_handle held = gd_variant_as_array(arrays);
  gd_variant vertices = item_of(&held, kArrayVertex);
  gd_variant indices = item_of(&held, kArrayIndex);
  gd_handle positions = gd_variant_as_pool_vector3(&vertices);
  const plp_result result = create(&positions, &indices, options, model);
  gd_pool_vector3_destroy(&positions);
  gd_variant_destroy(&indices);
  gd_variant_destroy(&vertices);
  gd_array_destroy(&held);
  return result;
}
