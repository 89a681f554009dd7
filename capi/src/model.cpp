#include <filesystem>
#include <span>

#include "capi/src/handles.h"
#include "capi/src/log.h"
#include "capi/src/numbers.h"
#include "capi/src/structs.h"
#include "capi/src/triangles.h"
#include "engine/base/clock.h"
#include "engine/gltf/gltf_file.h"

namespace palpate::capi {
namespace {

constexpr std::uint64_t kDefaultMaxTriangles = 100'000'000;
// Three corners a triangle are counted in 32 bits.
constexpr std::uint64_t kLibraryMaxTriangles = 1'000'000'000;
constexpr std::uint32_t kKnownFlags = PLP_MODEL_DOUBLE_SIDED | PLP_MODEL_KEEP_WINDING;

plp_model_options default_model_options() {
  plp_model_options options{};
  options.struct_size = sizeof options;
  options.gltf_scene = -1;
  options.scale = 1.0;
  return options;
}

plp_model_options checked_model_options(const plp_model_options* given) {
  if (!given) return default_model_options();
  const plp_model_options options = read_struct(given, "options");
  require((options.flags & ~kKnownFlags) == 0, "options->flags has a flag that this version does not know");
  require(options.reserved == 0, "options->reserved is not zero");
  require(options.gltf_scene >= -1, "options->gltf_scene is less than -1");
  checked_not_negative(options.weld_tolerance, "options->weld_tolerance");
  checked_not_negative(options.scale, "options->scale");
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

TriangleSoup scaled(TriangleSoup soup, const plp_model_options& options) {
  if (options.scale == 0.0 || options.scale == 1.0) return soup;
  for (DVec3& position : soup.positions) position *= options.scale;
  return soup;
}

// What a loader tells beside the triangles. Its notes come before those of the mesh.
struct LoadReport {
  std::vector<std::string> notes;
  LoadTally tally;
};

plp_model new_model(TriangleSoup soup, LoadReport report, const plp_model_options& options,
                    const std::string& name, const Stopwatch& watch) {
  Result<Mesh> built = build_mesh(scaled(std::move(soup), options), mesh_options(options));
  if (!built) refuse(built.error().code, name + ": " + built.error().message);
  Mesh mesh = std::move(built.value());
  std::vector<std::string>& notes = mesh.report.notes;
  notes.insert(notes.begin(), report.notes.begin(), report.notes.end());

  auto object = std::make_unique<ModelObject>();
  object->model = std::make_shared<const Model>(std::move(mesh));
  object->tally = report.tally;
  object->load_us = watch.elapsed_us();
  const std::shared_ptr<const Model> model = object->model;
  const double load_us = object->load_us;
  const auto handle = new_handle<plp_model>(model_table(), std::move(object));
  log_model(name, model->mesh().report, load_us);
  return handle;
}

plp_model new_gltf_model(const GltfScene& scene, const plp_model_options& options, const std::string& name,
                         const Stopwatch& watch) {
  return new_model(bake(scene), {scene.notes, scene.tally}, options, name, watch);
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_model_options_init(plp_model_options* options, size_t size) {
  fill_struct(default_model_options(), options, size);
}

plp_result plp_model_load_file(const char* path, const plp_model_options* options, plp_model* model) {
  return guarded([&] {
    const Stopwatch watch;
    require(path && *path, "path is null or empty");
    require(model, "model is null");
    const plp_model_options checked = checked_model_options(options);
    const GltfScene scene = value_or_refuse(read_gltf_file(path_of(path), gltf_options(checked)));
    *model = new_gltf_model(scene, checked, path, watch);
  });
}

plp_result plp_model_load_memory(const void* data, size_t size, const char* folder,
                                 const plp_model_options* options, plp_model* model) {
  return guarded([&] {
    const Stopwatch watch;
    require(data, "data is null");
    require(model, "model is null");
    const plp_model_options checked = checked_model_options(options);
    const std::span bytes(static_cast<const std::byte*>(data), size);
    const std::string name = "glTF in memory";
    const GltfScene scene =
        value_or_refuse(read_gltf_bytes(bytes, name, path_of(folder ? folder : ""), gltf_options(checked)));
    *model = new_gltf_model(scene, checked, name, watch);
  });
}

void plp_triangles_init(plp_triangles* triangles, size_t size) {
  plp_triangles filled{};
  filled.position_type = PLP_TYPE_FLOAT32;
  filled.index_type = PLP_TYPE_UINT32;
  filled.space = kPalpateSpace;
  fill_struct(filled, triangles, size);
}

plp_result plp_model_create_from_triangles(const plp_triangles* triangles, const plp_model_options* options,
                                           plp_model* model) {
  return guarded([&] {
    const Stopwatch watch;
    require(model, "model is null");
    const plp_triangles given = read_struct(triangles, "triangles");
    const plp_model_options checked = checked_model_options(options);
    *model = new_model(read_triangles(given, max_triangles(checked)), {}, checked, "triangles", watch);
  });
}

plp_result plp_model_retain(plp_model model) {
  return guarded([&] {
    const SlotTable::Outcome outcome = model_table().retain(bits_of(model));
    if (outcome == SlotTable::Outcome::kFull)
      refuse(ErrorCode::kLimit, "model has 65,535 references already");
    require_handle(outcome == SlotTable::Outcome::kDone, "model");
  });
}

plp_result plp_model_release(plp_model model) {
  return guarded([&] { release_handle(model_table(), model, "model"); });
}
