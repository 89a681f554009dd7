#include "engine/gltf/gltf_document.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "engine/gltf/gltf_json.h"
#include "engine/gltf/load_error.h"
#include "engine/gltf/required_extensions.h"

// tinygltf skips optional properties of a wrong type, narrows integers and opens images and buffers as it
// parses. So it is given a document reduced to the properties listed here, each of them checked, and without
// a single URI.

namespace palpate::gltf {
namespace {

using enum JsonKind;

constexpr JsonProperty kRoot[] = {{"asset", kObject, true}, {"accessors", kArray}, {"bufferViews", kArray},
                                  {"materials", kArray},    {"meshes", kArray},    {"nodes", kArray},
                                  {"scene", kIndex},        {"scenes", kArray},    {"skins", kArray}};
constexpr JsonProperty kAsset[] = {{"version", kText, true}, {"minVersion", kText}};
constexpr JsonProperty kBuffer[] = {{"byteLength", kSize, true}, {"uri", kText}};
constexpr JsonProperty kBufferView[] = {
    {"buffer", kIndex, true}, {"byteOffset", kSize}, {"byteLength", kSize, true}, {"byteStride", kSize}};
constexpr JsonProperty kAccessor[] = {
    {"bufferView", kIndex}, {"byteOffset", kSize}, {"componentType", kIndex, true},
    {"count", kSize, true}, {"type", kText, true}, {"normalized", kFlag},
    {"sparse", kObject}};
constexpr JsonProperty kSparse[] = {
    {"count", kIndex, true}, {"indices", kObject, true}, {"values", kObject, true}};
constexpr JsonProperty kSparseIndices[] = {
    {"bufferView", kIndex, true}, {"byteOffset", kIndex}, {"componentType", kIndex, true}};
constexpr JsonProperty kSparseValues[] = {{"bufferView", kIndex, true}, {"byteOffset", kIndex}};
constexpr JsonProperty kMaterial[] = {{"doubleSided", kFlag}};
constexpr JsonProperty kMesh[] = {{"name", kText}, {"primitives", kArray, true}, {"weights", kNumbers}};
constexpr JsonProperty kPrimitive[] = {{"attributes", kIndexByName, true},
                                       {"indices", kIndex},
                                       {"material", kIndex},
                                       {"mode", kIndex},
                                       {"targets", kArray}};
constexpr JsonProperty kNode[] = {{"name", kText},      {"mesh", kIndex},          {"skin", kIndex},
                                  {"matrix", kNumbers}, {"translation", kNumbers}, {"rotation", kNumbers},
                                  {"scale", kNumbers},  {"weights", kNumbers},     {"children", kIndices}};
constexpr JsonProperty kScene[] = {{"nodes", kIndices}};
constexpr JsonProperty kSkin[] = {{"joints", kIndices, true}, {"inverseBindMatrices", kIndex}};
constexpr JsonProperty kMeshopt[] = {{"buffer", kIndex, true},
                                     {"byteOffset", kSize},
                                     {"byteLength", kSize, true},
                                     {"byteStride", kSize, true},
                                     {"count", kSize, true},
                                     {"mode", kText, true},
                                     {"filter", kText}};
constexpr JsonProperty kDraco[] = {{"bufferView", kIndex, true}, {"attributes", kIndexByName, true}};
constexpr JsonProperty kInstancing[] = {{"attributes", kIndexByName, true}};

void reduce_asset(Json& root) {
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object())
    fail(ErrorCode::kBadFormat, "not a glTF file: no \"asset\" object");
  within("asset of glTF", 2, [&] { reduce(*asset, kAsset); });
  const auto version = asset->at("version").get<std::string>();
  if (!version.starts_with("2."))
    fail(ErrorCode::kUnsupported, "glTF version ", quoted(version), " instead of 2.0");
  const std::string least = asset->value("minVersion", "2.0");
  if (least != "2.0") fail(ErrorCode::kUnsupported, "it needs a reader of glTF version ", quoted(least));
}

void take_buffers(Json& root, GltfDocument& document) {
  for_each_object(root, "buffers", "buffer", [&](std::size_t, Json& buffer) {
    reduce(buffer, kBuffer);
    BufferSource source;
    source.byte_length = buffer["byteLength"].get<std::uint64_t>();
    if (const auto uri = buffer.find("uri"); uri != buffer.end())
      source.uri = std::move(uri->get_ref<std::string&>());
    document.buffers.push_back(std::move(source));
  });
}

MeshoptMode meshopt_mode(const std::string& name) {
  if (name == "ATTRIBUTES") return MeshoptMode::kAttributes;
  if (name == "TRIANGLES") return MeshoptMode::kTriangles;
  if (name == "INDICES") return MeshoptMode::kIndices;
  fail(ErrorCode::kUnsupported, "meshopt mode ", quoted(name), " is not known");
}

std::optional<MeshoptBlock> take_meshopt(Json& view) {
  Json* json = find_extension(view, "EXT_meshopt_compression");
  if (json == nullptr) json = find_extension(view, "KHR_meshopt_compression");
  if (json == nullptr) return std::nullopt;
  reduce(*json, kMeshopt);
  MeshoptBlock block;
  block.buffer = json->at("buffer").get<int>();
  block.byte_offset = json->value("byteOffset", std::uint64_t{0});
  block.byte_length = json->at("byteLength").get<std::uint64_t>();
  block.byte_stride = json->at("byteStride").get<std::uint64_t>();
  block.count = json->at("count").get<std::uint64_t>();
  block.mode = meshopt_mode(json->at("mode").get<std::string>());
  block.filter = json->value("filter", "NONE");
  return block;
}

void check_stride(const Json& view) {
  const auto stride = view.value("byteStride", std::uint64_t{0});
  if (stride > 252 || stride % 4 != 0)
    fail(ErrorCode::kBadFormat, "byteStride ", stride, " is not a multiple of 4 up to 252");
}

void reduce_views(Json& root, GltfDocument& document) {
  for_each_object(root, "bufferViews", "bufferView", [&](std::size_t, Json& view) {
    document.meshopt.push_back(take_meshopt(view));
    reduce(view, kBufferView);
    check_stride(view);
  });
}

// What tinygltf would refuse, too, but without telling where.
void check_element(const Json& accessor) {
  constexpr std::string_view kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  const auto& type = accessor.at("type").get_ref<const std::string&>();
  if (std::find(std::begin(kTypes), std::end(kTypes), type) == std::end(kTypes))
    fail(ErrorCode::kBadFormat, "type ", quoted(type), " is not known");
  const int component_type = accessor.at("componentType").get<int>();
  if (component_type < TINYGLTF_COMPONENT_TYPE_BYTE || component_type > TINYGLTF_COMPONENT_TYPE_FLOAT)
    fail(ErrorCode::kBadFormat, "component type ", component_type, " is not known");
}

void reduce_accessors(Json& root) {
  for_each_object(root, "accessors", "accessor", [](std::size_t, Json& accessor) {
    reduce(accessor, kAccessor);
    check_element(accessor);
    const auto sparse = accessor.find("sparse");
    if (sparse == accessor.end()) return;
    reduce(*sparse, kSparse);
    reduce(sparse->at("indices"), kSparseIndices);
    reduce(sparse->at("values"), kSparseValues);
  });
}

PrimitiveExtra take_primitive_extra(Json& primitive) {
  PrimitiveExtra extra;
  if (Json* draco = find_extension(primitive, "KHR_draco_mesh_compression")) {
    reduce(*draco, kDraco);
    extra.draco = DracoBlock{draco->at("bufferView").get<int>(), draco->at("attributes")};
  }
  reduce(primitive, kPrimitive);
  if (const auto indices = primitive.find("indices"); indices != primitive.end()) {
    extra.indices = indices->get<int>();
    primitive.erase(indices);
  }
  return extra;
}

void check_targets(const Json& primitive) {
  constexpr JsonProperty kTarget[] = {{"targets", kIndexByName}};
  const auto targets = primitive.find("targets");
  if (targets == primitive.end()) return;
  for (const Json& target : *targets) {
    Json holder{{"targets", target}};
    reduce(holder, kTarget);
  }
}

void reduce_meshes(Json& root, GltfDocument& document) {
  for_each_object(root, "meshes", "mesh", [&](std::size_t, Json& mesh) {
    reduce(mesh, kMesh);
    std::vector<PrimitiveExtra>& extras = document.primitive_extras.emplace_back();
    for_each_object(mesh, "primitives", "primitive", [&](std::size_t, Json& primitive) {
      extras.push_back(take_primitive_extra(primitive));
      check_targets(primitive);
    });
  });
}

void reduce_nodes(Json& root, GltfDocument& document, const GltfLimits& limits) {
  const auto nodes = root.find("nodes");
  if (nodes != root.end() && nodes->size() > limits.max_nodes)
    fail(ErrorCode::kLimit, nodes->size(), " nodes, at most ", limits.max_nodes, " are allowed");
  for_each_object(root, "nodes", "node", [&](std::size_t, Json& node) {
    std::map<std::string, int>& accessors = document.instancing.emplace_back();
    if (Json* instancing = find_extension(node, "EXT_mesh_gpu_instancing")) {
      reduce(*instancing, kInstancing);
      accessors = instancing->at("attributes").get<std::map<std::string, int>>();
    }
    reduce(node, kNode);
  });
}

void reduce_all(Json& root, const char* name, const char* noun, std::span<const JsonProperty> wanted) {
  for_each_object(root, name, noun, [&](std::size_t, Json& object) { reduce(object, wanted); });
}

bool load_no_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                   void*) {
  return true;
}

void load_model(const Json& root, tinygltf::Model& model) {
  const std::string text = root.dump();
  if (text.size() > std::numeric_limits<unsigned int>::max())
    fail(ErrorCode::kLimit, "the JSON has more than ", std::numeric_limits<unsigned int>::max(), " bytes");
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(load_no_image, nullptr);
  std::string error;
  std::string warning;
  const bool loaded = loader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                                 static_cast<unsigned int>(text.size()), "");
  if (!loaded) fail(ErrorCode::kBadFormat, "tinygltf says ", quoted(error));
}

}  // namespace

GltfDocument read_document(std::string_view json_text, const GltfOptions& options) {
  Json root = parse_json(json_text);
  reduce_asset(root);
  check_required_extensions(root);
  GltfDocument document;
  if (options.hierarchy) document.haptics = read_haptics(root);
  take_buffers(root, document);
  reduce_views(root, document);
  reduce_accessors(root);
  reduce_meshes(root, document);
  reduce_nodes(root, document, options.limits);
  reduce_all(root, "materials", "material", kMaterial);
  reduce_all(root, "scenes", "scene", kScene);
  reduce_all(root, "skins", "skin", kSkin);
  reduce(root, kRoot);
  load_model(root, document.model);
  return document;
}

}  // namespace palpate::gltf
