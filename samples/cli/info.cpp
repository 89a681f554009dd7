#include <cinttypes>
#include <cstdio>
#include <iostream>

#include "samples/cli/commands.h"
#include "samples/cli/handles.h"
#include "samples/cli/json_writer.h"

namespace palpate::cli {
namespace {

const char* orientation_text(std::int32_t orientation) {
  switch (orientation) {
    case PLP_ORIENTATION_OUTWARD:
      return "outward";
    case PLP_ORIENTATION_INWARD:
      return "inward";
    case PLP_ORIENTATION_MIXED:
      return "mixed";
    default:
      return "open";
  }
}

void write_surface(JsonWriter& json, const plp_surface_counts& counts) {
  json.field("triangles", counts.triangles)
      .field("welded_vertices", counts.vertices)
      .field("edges", counts.edges)
      .field("watertight", counts.watertight != 0)
      .field("orientation", orientation_text(counts.orientation))
      .field("nonmanifold_edges", counts.nonmanifold_edges)
      .field("boundary_edges", counts.boundary_edges)
      .field("inconsistent_edges", counts.inconsistent_edges)
      .field("components", counts.components);
}

void write_repairs(JsonWriter& json, const plp_model_info& info) {
  json.field("stored_vertices", info.stored_vertices)
      .field("degenerate_triangles", info.degenerate_triangles)
      .field("duplicate_triangles", info.duplicate_triangles)
      .field("split_triangles", info.split_triangles)
      .field("reversed_triangles", info.reversed_triangles)
      .field("flipped_components", info.flipped_components)
      .field("double_sided_triangles", info.double_sided_triangles);
}

void write_notes(JsonWriter& json, plp_model model) {
  json.key("notes").open_array();
  for (std::uint32_t i = 0; const char* note = plp_model_note(model, i); ++i) json.value(note);
  json.close();
}

void print_json(plp_model model, const plp_model_info& info) {
  JsonWriter json(std::cout);
  json.open_object();
  write_surface(json, info.source);
  write_repairs(json, info);
  json.key("searched").open_object();
  write_surface(json, info.searched);
  json.close();
  json.key("bounds").open_object();
  json.field("min", std::span(info.bounds_min)).field("max", std::span(info.bounds_max)).close();
  json.field("diagonal", info.diagonal);
  write_notes(json, model);
  json.field("mesh_bytes", info.mesh_bytes)
      .field("tree_bytes", info.tree_bytes)
      .field("tree_nodes", info.tree_nodes)
      .field("load_us", info.load_us)
      .field("tree_us", info.tree_us)
      .field("read_bytes", info.read_bytes)
      .field("decoded_bytes", info.decoded_bytes)
      .close();
  std::cout << '\n';
}

void print_count(const char* name, std::uint64_t source, std::uint64_t searched) {
  std::printf("%-20s %12" PRIu64 " %12" PRIu64 "\n", name, source, searched);
}

void print_surfaces(const plp_surface_counts& source, const plp_surface_counts& searched) {
  std::printf("%-20s %12s %12s\n", "", "as it came", "searched");
  print_count("triangles", source.triangles, searched.triangles);
  print_count("welded vertices", source.vertices, searched.vertices);
  print_count("edges", source.edges, searched.edges);
  print_count("boundary edges", source.boundary_edges, searched.boundary_edges);
  print_count("non-manifold edges", source.nonmanifold_edges, searched.nonmanifold_edges);
  print_count("inconsistent edges", source.inconsistent_edges, searched.inconsistent_edges);
  print_count("components", source.components, searched.components);
  std::printf("%-20s %12s %12s\n", "watertight", source.watertight ? "yes" : "no",
              searched.watertight ? "yes" : "no");
  std::printf("%-20s %12s %12s\n\n", "orientation", orientation_text(source.orientation),
              orientation_text(searched.orientation));
}

void print_repair(const char* name, std::uint64_t count) {
  std::printf("%-34s %12" PRIu64 "\n", name, count);
}

void print_repairs(const plp_model_info& info) {
  print_repair("vertices stored in the file", info.stored_vertices);
  print_repair("degenerate triangles dropped", info.degenerate_triangles);
  print_repair("duplicate triangles dropped", info.duplicate_triangles);
  print_repair("triangles split", info.split_triangles);
  print_repair("triangles reversed", info.reversed_triangles);
  print_repair("components turned outward", info.flipped_components);
  print_repair("double-sided triangles", info.double_sided_triangles);
}

void print_table(plp_model model, const plp_model_info& info) {
  print_surfaces(info.source, info.searched);
  print_repairs(info);
  std::printf("\nbounds    %g %g %g to %g %g %g m, diagonal %g m\n", info.bounds_min[0], info.bounds_min[1],
              info.bounds_min[2], info.bounds_max[0], info.bounds_max[1], info.bounds_max[2], info.diagonal);
  std::printf("mesh      %" PRIu64 " bytes, loaded in %.0f us\n", info.mesh_bytes, info.load_us);
  std::printf("hierarchy %" PRIu64 " bytes, %" PRIu64 " nodes, built in %.0f us\n", info.tree_bytes,
              info.tree_nodes, info.tree_us);
  std::printf("files     %" PRIu64 " bytes read, %" PRIu64 " bytes decoded\n", info.read_bytes,
              info.decoded_bytes);
  for (std::uint32_t i = 0; const char* note = plp_model_note(model, i); ++i) std::printf("note: %s\n", note);
}

}  // namespace

void run_info(const InfoArguments& arguments) {
  const OwnedModel model = load_model(arguments.model, arguments.scale);
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  check(plp_model_get_info(model.get(), &info));
  if (arguments.json) {
    print_json(model.get(), info);
  } else {
    print_table(model.get(), info);
  }
}

}  // namespace palpate::cli
