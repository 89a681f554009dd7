#include "tests/fault/scenarios.h"

#include <array>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include "tests/capi/gltf_file.h"
#include "tests/fault/calls.h"
#include "tests/fault/device_scenarios.h"
#include "tests/trace/traces.h"

namespace palpate::test {
namespace {

constexpr double kCutoff = 0.1;

void keep_model(Journey& journey, plp_model model) {
  std::uint64_t hash = 0;
  plp_model_info info;
  plp_model_info_init(&info, sizeof info);
  journey("plp_model_prepare", [&] { return plp_model_prepare(model); });
  journey("plp_model_get_hash", [&] { return plp_model_get_hash(model, &hash); });
  journey("plp_model_get_info", [&] { return plp_model_get_info(model, &info); });
  for (std::uint32_t i = 0; const char* note = plp_model_note(model, i); ++i)
    journey.keep(note, std::strlen(note));
  journey.keep(hash);
  journey.keep(info.tree_nodes);
}

void triangles(Journey& journey) {
  plp_model model = new_model(journey, torus(0.5, 0.2, 12, 8));
  keep_model(journey, model);
  release(journey, model);
}

std::string corpus_bytes(const std::string& name) {
  std::ifstream stream(std::string(PALPATE_FUZZ_CORPUS "/gltf/") + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

template <const auto& kName>
void gltf_bytes(Journey& journey) {
  const std::string bytes = corpus_bytes(kName);
  plp_model model = nullptr;
  journey("plp_model_load_memory",
          [&] { return plp_model_load_memory(bytes.data(), bytes.size(), nullptr, nullptr, &model); });
  keep_model(journey, model);
  release(journey, model);
}

constexpr char kInstancing[] = "instancing", kMeshopt[] = "meshopt", kQuantized[] = "quantized",
               kSkin[] = "skin", kSparse[] = "sparse";

void gltf_json(Journey& journey, const Json& json) {
  const std::string text = json.dump();
  plp_model model = nullptr;
  journey("plp_model_load_memory",
          [&] { return plp_model_load_memory(text.data(), text.size(), nullptr, nullptr, &model); });
  keep_model(journey, model);
  release(journey, model);
}

void morph(Journey& journey) {
  Json json = gltf_of({torus(0.5, 0.2, 8, 6)});
  json["meshes"][0]["primitives"][0]["targets"] = Json::array({{{"POSITION", 0}}});
  json["meshes"][0]["weights"] = {0.5};
  add_node(json, {{"mesh", 0}});
  gltf_json(journey, json);
}

std::vector<unsigned char> draco_stream(const Shape& shape) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(shape.triangles.size()));
  const int attribute = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::uint32_t i = 0; i < shape.triangles.size(); ++i) {
    const auto& [a, b, c] = shape.triangles[i];
    builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(i), shape.positions[a].data(),
                                      shape.positions[b].data(), shape.positions[c].data());
  }
  draco::EncoderBuffer out;
  EXPECT_TRUE(draco::Encoder().EncodeMeshToBuffer(*builder.Finalize(), &out).ok());
  return {out.data(), out.data() + out.size()};
}

void draco_mesh(Journey& journey) {
  const Shape shape = torus(0.5, 0.2, 8, 6);
  const std::vector<unsigned char> stream = draco_stream(shape);
  Json json = gltf_of({shape});
  for (Json& accessor : json["accessors"]) accessor.erase("bufferView");
  json["bufferViews"] = {{{"buffer", 0}, {"byteLength", stream.size()}}};
  json["buffers"] = {
      {{"byteLength", stream.size()}, {"uri", "data:application/octet-stream;base64," + base64(stream)}}};
  json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  add_node(json, {{"mesh", 0}});
  gltf_json(journey, json);
}

// Two nodes that share a mesh, and one above another.
Json room_gltf() {
  Json json = gltf_of({box(0.5f, 0.5f, 0.5f), torus(0.3, 0.1, 8, 6)});
  const auto floor =
      add_node(json, {{"name", "floor"}, {"mesh", 0}, {"extras", {{"stiffness", 500}, {"friction", 0.2}}}});
  add_node(json, {{"name", "ring"}, {"mesh", 1}, {"translation", {0, 0.65, 0}}}, static_cast<int>(floor));
  add_node(json,
           {{"name", "pen"}, {"mesh", 0}, {"scale", {0.2, 0.2, 0.2}}, {"translation", {0.2, 0.63, 0.1}}});
  return json;
}

void gltf_file(Journey& journey) {
  const GltfFile file(room_gltf());
  const std::string path = file.path();
  plp_model model = nullptr;
  journey("plp_model_load_file", [&] { return plp_model_load_file(path.c_str(), nullptr, &model); });
  keep_model(journey, model);
  release(journey, model);
}

// All of an outcome but what it took.
void keep_contacts(Journey& journey, plp_scene scene) {
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  journey("plp_scene_get_contacts", [&] { return plp_scene_get_contacts(scene, &contacts); });
  contacts.work = {};
  const std::string bits = bits_of(contacts);
  journey.keep(bits.data(), bits.size());
  for (std::size_t i = 0; i < contacts.spring_count; ++i) journey.keep(contacts.springs[i]);
  for (std::size_t i = 0; i < contacts.overlap_count; ++i) journey.keep(contacts.overlaps[i]);
}

void step(Journey& journey, plp_scene scene) {
  journey("plp_scene_step", [&] { return plp_scene_step(scene); });
  keep_contacts(journey, scene);
}

void gltf_scene(Journey& journey) {
  const GltfFile file(room_gltf());
  const std::string path = file.path();
  const plp_scene scene = new_scene(journey, TestScene::options_with(kCutoff));
  plp_gltf_scene_options options;
  plp_gltf_scene_options_init(&options, sizeof options);
  options.tool = "pen";
  std::array<plp_body, 8> bodies{};
  std::size_t count = 0, listed = 0;
  plp_body ring = 0;
  plp_model model = nullptr;
  double matrix[16] = {};
  journey("plp_scene_load_gltf", [&] {
    return plp_scene_load_gltf(scene, path.c_str(), &options, bodies.data(), bodies.size(), &count);
  });
  journey("plp_scene_list_bodies",
          [&] { return plp_scene_list_bodies(scene, bodies.data(), bodies.size(), &listed); });
  journey("plp_scene_find_body", [&] { return plp_scene_find_body(scene, "ring", &ring); });
  plp_body_info info;
  plp_body_info_init(&info, sizeof info);
  journey("plp_scene_get_body_info", [&] { return plp_scene_get_body_info(scene, ring, &info); });
  journey("plp_scene_get_body_model", [&] { return plp_scene_get_body_model(scene, ring, &model); });
  journey("plp_scene_get_node_matrix", [&] { return plp_scene_get_node_matrix(scene, ring, matrix); });
  journey.keep(bodies);
  journey.keep(count);
  journey.keep(info);
  journey.keep(matrix);
  step(journey, scene);
  release(journey, model);
  release(journey, scene);
}

// A tool that comes near, slides, crosses the surface and leaves, while bodies and settings change.
void touch(Journey& journey, const plp_scene_options& options) {
  const plp_model ring = new_model(journey, torus(0.5, 0.2, 12, 8)),
                  cube = new_model(journey, box(0.3f, 0.2f, 0.25f));
  const plp_scene scene = new_scene(journey, options);
  add(journey, scene, ring, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body other = add(journey, scene, cube, PLP_BODY_MOVING, at(1.0, 0.7, 0.0));
  plp_body tool = add(journey, scene, cube, PLP_BODY_TOOL, at(1.2, 0, 0));
  for (int i = 0; i < 24; ++i) {
    const double way = i < 16 ? 1.09 - 0.01 * i : 0.97 + 0.02 * (i - 16);
    place(journey, scene, tool, {{way, 0.004 * i, 0.0}, {0.0, 0.01 * i, 0.02, 1.0}});
    if (i == 4) place(journey, scene, other, at(1.0, 0.5, 0.0));
    if (i == 10) journey("plp_scene_set_cutoff", [&] { return plp_scene_set_cutoff(scene, 1.2 * kCutoff); });
    if (i == 12) journey("plp_scene_remove_body", [&] { return plp_scene_remove_body(scene, other); });
    if (i == 14) journey("plp_scene_set_stiffness", [&] { return plp_scene_set_stiffness(scene, 700.0); });
    step(journey, scene);
  }
  // What the next step looks for depends on what the one before had found.
  const bool goes_on = options.mode == PLP_MODE_DESCENT || options.tick_budget > 0;
  if (goes_on && journey.failed_call() == std::string("plp_scene_step")) journey.ends_otherwise();
  journey("plp_scene_remove_body", [&] { return plp_scene_remove_body(scene, tool); });
  tool = add(journey, scene, ring, PLP_BODY_TOOL, at(0.0, 0.0, 0.45));
  step(journey, scene);
  release(journey, scene);
  release(journey, ring);
  release(journey, cube);
}

template <plp_mode kMode, plp_law kLaw, unsigned kThreads = 1>
void touch(Journey& journey) {
  plp_scene_options options = TestScene::options_with(kCutoff);
  options.mode = kMode;
  options.law = kLaw;
  options.threads = kThreads;
  options.damping = 2.0;
  options.friction = 0.3;
  options.stiffness_cap = 3000.0;
  touch(journey, options);
}

void budget(Journey& journey) {
  plp_scene_options options = TestScene::options_with(kCutoff);
  options.tick_budget = 256;
  touch(journey, options);
}

void query(Journey& journey) {
  const plp_model ring = new_model(journey, torus(0.5, 0.2, 12, 8)),
                  cube = new_model(journey, box(0.3f, 0.2f, 0.25f));
  plp_query_result result = nullptr;
  journey("plp_query_result_create", [&] { return plp_query_result_create(&result); });
  for (const plp_law law : {PLP_LAW_SPRINGS, PLP_LAW_SMOOTH}) {
    plp_query_options options;
    plp_query_options_init(&options, sizeof options);
    options.cutoff = kCutoff;
    options.law = law;
    const plp_pose pose = at(0.95, 0.1, 0.0);
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    journey("plp_query", [&] { return plp_query(ring, cube, &pose, &options, result); });
    journey("plp_query_result_get", [&] { return plp_query_result_get(result, &contacts); });
    const std::string bits = bits_of(contacts);
    journey.keep(bits.data(), bits.size());
  }
  journey("plp_query_result_release", [&] { return plp_query_result_release(result); });
  release(journey, ring);
  release(journey, cube);
}

void wait_for_ticks(plp_scene scene, std::uint64_t count) {
  plp_servo_state state;
  plp_servo_state_init(&state, sizeof state);
  do {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    plp_scene_get_servo(scene, &state);
  } while (state.running && state.ticks < count);
}

// What the servo saw is as the scheduler pleased; where it stands in the end is not.
void servo(Journey& journey) {
  const plp_model ring = new_model(journey, torus(0.5, 0.2, 12, 8)),
                  cube = new_model(journey, box(0.3f, 0.2f, 0.25f));
  plp_scene_options options = TestScene::options_with(kCutoff);
  options.fade_time = 0.0;
  const plp_scene scene = new_scene(journey, options);
  const plp_body tool = add(journey, scene, cube, PLP_BODY_TOOL, at(1.05, 0, 0));
  add(journey, scene, ring, PLP_BODY_STATIC, at(0, 0, 0));
  plp_servo_options servo;
  plp_servo_options_init(&servo, sizeof servo);
  servo.rate = 10'000.0;
  servo.priority = -1;
  journey("plp_scene_start", [&] { return plp_scene_start(scene, &servo); });
  wait_for_ticks(scene, 3);
  const plp_body other = add(journey, scene, cube, PLP_BODY_MOVING, at(1.0, 0.5, 0.0));
  place(journey, scene, tool, at(1.04, 0.01, 0.0));
  journey("plp_scene_set_mode", [&] { return plp_scene_set_mode(scene, PLP_MODE_DESCENT); });
  journey("plp_scene_set_law", [&] { return plp_scene_set_law(scene, PLP_LAW_SMOOTH); });
  wait_for_ticks(scene, 10);
  journey("plp_scene_remove_body", [&] { return plp_scene_remove_body(scene, other); });
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  journey("plp_scene_get_contacts", [&] { return plp_scene_get_contacts(scene, &contacts); });
  journey("plp_scene_stop", [&] { return plp_scene_stop(scene); });
  journey("plp_scene_set_mode", [&] { return plp_scene_set_mode(scene, PLP_MODE_CERTIFIED); });
  place(journey, scene, tool, at(1.03, 0.0, 0.01));
  step(journey, scene);
  release(journey, scene);
  release(journey, ring);
  release(journey, cube);
}

void record(Journey& journey, plp_scene scene, plp_body tool, const TraceFile& file) {
  journey("plp_scene_record", [&] { return plp_scene_record(scene, file.path()); });
  for (int i = 0; i < 6; ++i) {
    place(journey, scene, tool, at(1.1 - 0.01 * i, 0, 0));
    step(journey, scene);
  }
}

void replay(Journey& journey, const TraceFile& file) {
  plp_trace trace = nullptr;
  journey("plp_trace_open", [&] { return plp_trace_open(file.path(), &trace); });
  plp_scene_options options = TestScene::options_with(1.0);
  plp_trace_body body;
  plp_trace_body_init(&body, sizeof body);
  journey("plp_trace_get_options", [&] { return plp_trace_get_options(trace, &options); });
  journey("plp_trace_get_body", [&] { return plp_trace_get_body(trace, 1, &body); });
  const plp_model cube = new_model(journey, box(0.5f, 0.5f, 0.5f));
  const plp_scene scene = new_scene(journey, options);
  add(journey, scene, cube, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body tool = add(journey, scene, cube, PLP_BODY_TOOL, at(0, 0, 0));
  for (std::uint64_t i = 0; i < 6; ++i) {
    plp_trace_tick tick;
    plp_trace_tick_init(&tick, sizeof tick);
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    journey("plp_trace_read", [&] { return plp_trace_read(trace, i, &tick); });
    journey("plp_trace_get_contacts", [&] { return plp_trace_get_contacts(trace, &contacts); });
    journey.keep(contacts.wrench);
    journey("plp_trace_place", [&] { return plp_trace_place(trace, i, body.body, scene, tool); });
    step(journey, scene);
  }
  journey("plp_trace_release", [&] { return plp_trace_release(trace); });
  release(journey, scene);
  release(journey, cube);
}

void trace(Journey& journey) {
  const TraceFile file;
  const plp_model cube = new_model(journey, box(0.5f, 0.5f, 0.5f));
  const plp_scene scene = new_scene(journey, TestScene::options_with(0.2));
  add(journey, scene, cube, PLP_BODY_STATIC, at(0, 0, 0));
  const plp_body tool = add(journey, scene, cube, PLP_BODY_TOOL, at(1.1, 0, 0));
  record(journey, scene, tool, file);
  // Ended all the same, and told; what is whole can be read.
  const bool whole =
      journey.try_once("plp_scene_stop_recording", [&] { return plp_scene_stop_recording(scene, nullptr); });
  if (!whole) {
    journey.ends_otherwise();
    record(journey, scene, tool, file);
  }
  release(journey, scene);
  release(journey, cube);
  if (whole) replay(journey, file);
}

}  // namespace

const std::vector<Scenario>& scenarios() {
  static const std::vector<Scenario> all = {
      {"Triangles", triangles},
      {"GltfDraco", draco_mesh},
      {"GltfInstancing", gltf_bytes<kInstancing>},
      {"GltfMeshopt", gltf_bytes<kMeshopt>},
      {"GltfMorph", morph},
      {"GltfQuantized", gltf_bytes<kQuantized>},
      {"GltfSkin", gltf_bytes<kSkin>},
      {"GltfSparse", gltf_bytes<kSparse>},
      {"GltfFile", gltf_file},
      {"GltfScene", gltf_scene},
      {"GlobalSprings", touch<PLP_MODE_GLOBAL, PLP_LAW_SPRINGS>},
      {"GlobalSmooth", touch<PLP_MODE_GLOBAL, PLP_LAW_SMOOTH>},
      {"DescentSprings", touch<PLP_MODE_DESCENT, PLP_LAW_SPRINGS>},
      {"DescentSmooth", touch<PLP_MODE_DESCENT, PLP_LAW_SMOOTH>},
      {"CertifiedSprings", touch<PLP_MODE_CERTIFIED, PLP_LAW_SPRINGS>},
      {"CertifiedSmooth", touch<PLP_MODE_CERTIFIED, PLP_LAW_SMOOTH>},
      {"Budget", budget},
      {"StepThreads", touch<PLP_MODE_CERTIFIED, PLP_LAW_SMOOTH, 2>, true},
      {"Query", query},
      {"Servo", servo, true},
      {"SimulatedDevice", simulated_device},
      {"OpenHapticsDevice", openhaptics_device, true},
#ifdef PALPATE_FAULT_HID
      {"HidDevice", hid_device, true},
      {"SpaceMouse", space_mouse, true},
#endif
      {"Trace", trace, true},
  };
  return all;
}

}  // namespace palpate::test
