#include "capi/src/model_options.h"

#include <algorithm>

#include "capi/src/log.h"
#include "capi/src/numbers.h"
#include "capi/src/structs.h"

namespace palpate::capi {
namespace {

constexpr std::uint64_t kDefaultMaxTriangles = 100'000'000;
// Three corners a triangle are counted in 32 bits.
constexpr std::uint64_t kLibraryMaxTriangles = 1'000'000'000;
constexpr std::uint32_t kKnownFlags = PLP_MODEL_DOUBLE_SIDED | PLP_MODEL_KEEP_WINDING;

}  // namespace

plp_model_options default_model_options() {
  plp_model_options options{};
  options.struct_size = sizeof options;
  options.gltf_scene = -1;
  options.scale = 1.0;
  return options;
}

plp_model_options checked_model_options(const plp_model_options* given, const char* name) {
  if (!given) return default_model_options();
  const plp_model_options options = read_struct(given, name);
  if ((options.flags & ~kKnownFlags) != 0)
    refuse_argument(name, "->flags has a flag that this version does not know");
  if (options.reserved != 0) refuse_argument(name, "->reserved is not zero");
  if (options.gltf_scene < -1) refuse_argument(name, "->gltf_scene is less than -1");
  checked_not_negative(options.weld_tolerance, (std::string(name) + "->weld_tolerance").c_str());
  checked_not_negative(options.scale, (std::string(name) + "->scale").c_str());
  return options;
}

std::uint64_t max_triangles(const plp_model_options& options) {
  const std::uint64_t wanted = options.max_triangles != 0 ? options.max_triangles : kDefaultMaxTriangles;
  return std::min(wanted, kLibraryMaxTriangles);
}

MeshOptions mesh_options(const plp_model_options& options) {
  MeshOptions mesh;
  mesh.weld_tolerance = options.weld_tolerance;
  mesh.all_double_sided = (options.flags & PLP_MODEL_DOUBLE_SIDED) != 0;
  mesh.keep_winding = (options.flags & PLP_MODEL_KEEP_WINDING) != 0;
  return mesh;
}

GltfOptions gltf_options(const plp_model_options& options) {
  GltfOptions gltf;
  gltf.scene = options.gltf_scene;
  gltf.limits.max_triangles = max_triangles(options);
  return gltf;
}

std::filesystem::path path_of(const char* utf8) {
  return {reinterpret_cast<const char8_t*>(utf8)};
}

void log_model(const std::string& name, const MeshReport& report, double load_us) {
  for (const std::string& note : report.notes) log_quietly(LogLevel::kWarning, name + ": " + note);
  log_quietly(LogLevel::kInfo, name + ": " + std::to_string(report.final.triangles) + " triangles and " +
                                   std::to_string(report.final.vertices) + " vertices in " +
                                   std::to_string(static_cast<std::uint64_t>(load_us)) + " us");
}

double scale_of(const plp_model_options& options) {
  return options.scale == 0.0 ? 1.0 : options.scale;
}

}  // namespace palpate::capi
