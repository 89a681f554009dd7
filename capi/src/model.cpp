#include <span>

#include "capi/src/handles.h"
#include "capi/src/model_options.h"
#include "capi/src/structs.h"
#include "capi/src/triangles.h"
#include "engine/base/clock.h"
#include "engine/gltf/gltf_file.h"

namespace palpate::capi {
namespace {

TriangleSoup scaled(TriangleSoup soup, const plp_model_options& options) {
  const double scale = scale_of(options);
  if (scale == 1.0) return soup;
  for (DVec3& position : soup.positions) position *= scale;
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
  object->name = path_of(name.c_str()).filename().string();
  log_model(name, object->model->mesh().report, object->load_us);
  return new_handle<plp_model>(model_table(), std::move(object));
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
    const plp_model_options checked = checked_model_options(options, "options");
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
    const plp_model_options checked = checked_model_options(options, "options");
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
    const plp_model_options checked = checked_model_options(options, "options");
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
