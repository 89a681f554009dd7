#include "capi/src/handles.h"
#include "capi/src/structs.h"

namespace palpate::capi {
namespace {

plp_surface_counts counts_of(const SurfaceCounts& counts) {
  plp_surface_counts out{};
  out.triangles = counts.triangles;
  out.vertices = counts.vertices;
  out.edges = counts.edges;
  out.boundary_edges = counts.boundary_edges;
  out.nonmanifold_edges = counts.nonmanifold_edges;
  out.inconsistent_edges = counts.inconsistent_edges;
  out.components = counts.components;
  out.orientation = static_cast<std::int32_t>(counts.orientation);
  out.watertight = counts.watertight();
  return out;
}

static_assert(static_cast<int>(Orientation::kOpen) == PLP_ORIENTATION_OPEN);
static_assert(static_cast<int>(Orientation::kOutward) == PLP_ORIENTATION_OUTWARD);
static_assert(static_cast<int>(Orientation::kInward) == PLP_ORIENTATION_INWARD);
static_assert(static_cast<int>(Orientation::kMixed) == PLP_ORIENTATION_MIXED);

void describe_mesh(const MeshReport& report, plp_model_info& info) {
  info.note_count = static_cast<std::uint32_t>(report.notes.size());
  info.source = counts_of(report.source);
  info.searched = counts_of(report.final);
  info.stored_vertices = report.stored_vertices;
  info.degenerate_triangles = report.degenerate_triangles;
  info.duplicate_triangles = report.duplicate_triangles;
  info.split_triangles = report.split_triangles;
  info.reversed_triangles = report.reversed_triangles;
  info.flipped_components = report.flipped_components;
  info.double_sided_triangles = report.double_sided_triangles;
}

// There is one tree for each law.
void add_tree(const Tree& tree, std::size_t bytes, plp_model_info& info) {
  info.tree_bytes += bytes;
  info.tree_nodes += tree.node_count();
  info.tree_us += tree.build_us();
}

plp_model_info info_of(const ModelObject& object) {
  const Model& model = *object.model;
  plp_model_info info{};
  describe_mesh(model.mesh().report, info);
  for (int i = 0; i < 3; ++i) {
    info.bounds_min[i] = model.bounds().low[i];
    info.bounds_max[i] = model.bounds().high[i];
  }
  info.diagonal = model.bounds().diagonal();
  info.mesh_bytes = model.mesh().bytes();
  info.load_us = object.load_us;
  info.read_bytes = object.tally.read_bytes;
  info.decoded_bytes = object.tally.decoded_bytes;
  if (const Tree* tree = model.tree_if_built()) add_tree(*tree, tree->bytes(), info);
  if (const NearTree* near = model.near_tree_if_built()) add_tree(near->tree, near->bytes(), info);
  return info;
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_model_info_init(plp_model_info* info, size_t size) {
  fill_struct(plp_model_info{}, info, size);
}

plp_result plp_model_get_info(plp_model model, plp_model_info* info) {
  return guarded([&] {
    const auto object = model_table().pin(bits_of(model));
    require_handle(object, "model");
    write_struct(info_of(*object), info, "info");
  });
}

const char* plp_model_note(plp_model model, uint32_t index) {
  const char* note = nullptr;
  guarded([&] {
    const auto object = model_table().pin(bits_of(model));
    require_handle(object, "model");
    const std::vector<std::string>& notes = object->model->mesh().report.notes;
    if (index < notes.size()) note = notes[index].c_str();
  });
  return note;
}

plp_result plp_model_prepare(plp_model model) {
  return guarded([&] {
    const auto object = model_table().pin(bits_of(model));
    require_handle(object, "model");
    object->model->tree();
    object->model->near_tree();
  });
}
