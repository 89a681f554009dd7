/* SPDX-License-Identifier: MIT */
/* A model from the arrays of a Mesh. */
#ifndef PALPATE_BINDINGS_GODOT_MESH_ARRAYS_H
#define PALPATE_BINDINGS_GODOT_MESH_ARRAYS_H

#include <palpate/palpate.h>

#include "godot.h"

/* @param arrays what Mesh.surface_get_arrays and PrimitiveMesh.get_mesh_arrays give, of triangles. @return as
 * plp_model_create_from_triangles. */
plp_result model_from_mesh_arrays(const gd_variant* arrays, const plp_model_options* options,
                                  plp_model* model);

#endif /* PALPATE_BINDINGS_GODOT_MESH_ARRAYS_H */
