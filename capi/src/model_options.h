#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "engine/gltf/gltf_options.h"
#include "engine/mesh/mesh.h"
#include "palpate/palpate.h"

namespace palpate::capi {

plp_model_options default_model_options();

// The defaults for null. `name` is what sentences call the argument.
plp_model_options checked_model_options(const plp_model_options* given, const char* name);

double scale_of(const plp_model_options& options);
std::uint64_t max_triangles(const plp_model_options& options);
MeshOptions mesh_options(const plp_model_options& options);
GltfOptions gltf_options(const plp_model_options& options);

std::filesystem::path path_of(const char* utf8);

// What was repaired as warnings, and how large the model is.
void log_model(const std::string& name, const MeshReport& report, double load_us);

}  // namespace palpate::capi
