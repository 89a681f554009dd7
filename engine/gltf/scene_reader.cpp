#include "engine/gltf/scene_reader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "engine/gltf/gpu_instancing.h"
#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

constexpr std::uint32_t kNoSoup = 0xFFFFFFFF;

}  // namespace

SceneReader::SceneReader(const GltfDocument& document, BufferStore& buffers, LoadBudget& budget,
                         const GltfOptions& options)
    : document_(document),
      budget_(budget),
      wanted_scene_(options.scene),
      hierarchy_(options.hierarchy),
      accessors_(document, buffers, budget),
      tree_(document, options.limits),
      meshes_(document, accessors_, budget, scene_.notes) {}

GltfScene SceneReader::read() && {
  const std::vector<int> order = tree_.walk(scene_roots());
  for (const int node : order) within("node", static_cast<std::size_t>(node), [&] { read_node(node); });
  if (scene_.instances.empty()) {
    if (meshes_.skipped() == 0) fail(ErrorCode::kNoTriangles, "the scene has no triangles");
    fail(ErrorCode::kNoTriangles,
         "the scene has no triangles (primitives of points or lines: ", meshes_.skipped(), ")");
  }
  if (hierarchy_) read_hierarchy(order);
  return std::move(scene_);
}

// In `order` parents come before their children.
void SceneReader::read_hierarchy(const std::vector<int>& order) {
  std::vector<std::int32_t> places(document_.model.nodes.size(), -1);
  scene_.filters = document_.haptics.filters;
  scene_.notes.insert(scene_.notes.end(), document_.haptics.notes.begin(), document_.haptics.notes.end());
  for (const int index : order) {
    GltfNode node = node_of(index);
    node.parent = tree_.parent(index) < 0 ? -1 : places[static_cast<std::size_t>(tree_.parent(index))];
    if (node.parent >= 0) node.moves |= scene_.nodes[static_cast<std::size_t>(node.parent)].moves;
    places[static_cast<std::size_t>(index)] = static_cast<std::int32_t>(scene_.nodes.size());
    scene_.nodes.push_back(std::move(node));
  }
}

// What the node says of itself, its mesh says of it, and its physics material, in this order.
GltfNode SceneReader::node_of(int index) const {
  const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(index)];
  const NodeHaptics& haptics = document_.haptics.nodes[static_cast<std::size_t>(index)];
  GltfNode read;
  read.index = static_cast<std::uint32_t>(index);
  read.name = node.name;
  read.scene_from_node = tree_.scene_from_node(index);
  read.moves = haptics.moves;
  read.solid = haptics.solid;
  read.filter = haptics.collision_filter;
  read.material = haptics.material;
  if (node.mesh >= 0 && node.name.empty())
    read.name = document_.model.meshes[static_cast<std::size_t>(node.mesh)].name;
  if (node.mesh >= 0)
    read.material = first_of(read.material, document_.haptics.meshes[static_cast<std::size_t>(node.mesh)]);
  if (haptics.physics_material >= 0)
    read.material = first_of(read.material,
                             document_.haptics.frictions[static_cast<std::size_t>(haptics.physics_material)]);
  return read;
}

std::vector<int> SceneReader::scene_roots() {
  const auto count = static_cast<int>(document_.model.scenes.size());
  if (wanted_scene_ >= count || wanted_scene_ < -1)
    fail(ErrorCode::kInvalidArgument, "scene ", wanted_scene_, " was asked for and there are ", count);
  if (count == 0) {
    if (document_.model.defaultScene >= 0)
      fail(ErrorCode::kBadFormat, "the default scene ", document_.model.defaultScene, " does not exist");
    if (document_.model.nodes.empty()) fail(ErrorCode::kNoTriangles, "it has neither a scene nor a node");
    scene_.notes.push_back("The file has no scene; all of its nodes were read.");
    return tree_.roots();
  }
  const int index = wanted_scene_ >= 0 ? wanted_scene_ : std::max(document_.model.defaultScene, 0);
  if (index >= count) fail(ErrorCode::kBadFormat, "the default scene ", index, " does not exist");
  return document_.model.scenes[static_cast<std::size_t>(index)].nodes;
}

SceneReader::SoupKey SceneReader::key_of(const tinygltf::Node& node) const {
  const auto mesh = static_cast<std::size_t>(node.mesh);
  if (mesh >= document_.model.meshes.size())
    fail(ErrorCode::kBadFormat, "mesh ", node.mesh, " does not exist");
  std::vector<double> weights = node.weights.empty() ? document_.model.meshes[mesh].weights : node.weights;
  while (!weights.empty() && weights.back() == 0.0) weights.pop_back();  // missing ones are zero
  return {node.mesh, node.skin, std::move(weights)};
}

std::uint32_t SceneReader::soup_of(const SoupKey& key) {
  const auto known = soups_.find(key);
  if (known != soups_.end()) return known->second;
  const auto& [mesh, skin_index, weights] = key;
  std::optional<Skin> skin;
  if (skin_index >= 0) skin.emplace(skin_index, document_, tree_, accessors_);
  TriangleSoup soup = meshes_.read(mesh, weights, skin ? &*skin : nullptr);
  std::uint32_t index = kNoSoup;
  if (!soup.triangles.empty()) {
    index = static_cast<std::uint32_t>(scene_.meshes.size());
    scene_.meshes.push_back(std::move(soup));
  }
  soups_.emplace(key, index);
  return index;
}

// Where the node's mesh occurs; all of it is taken from the budget first.
std::vector<DMat4> SceneReader::places_of(int index, std::uint64_t triangles) {
  const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(index)];
  const std::map<std::string, int>& instancing = document_.instancing[static_cast<std::size_t>(index)];
  const bool repeated = !instancing.empty() && node.skin < 0;
  budget_.take_instances(repeated ? count_gpu_instances(instancing, accessors_) : 1, triangles);
  if (node.skin >= 0) return {DMat4(1.0)};  // joints alone place a skinned mesh
  const DMat4& scene_from_node = tree_.scene_from_node(index);
  if (!repeated) return {scene_from_node};
  std::vector<DMat4> places = read_gpu_instances(instancing, accessors_);
  for (DMat4& place : places) place = scene_from_node * place;
  return places;
}

void SceneReader::read_node(int index) {
  const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(index)];
  if (node.mesh < 0) return;
  const std::uint32_t soup = soup_of(key_of(node));
  if (soup == kNoSoup) return;
  for (const DMat4& place : places_of(index, scene_.meshes[soup].triangles.size()))
    scene_.instances.push_back({soup, static_cast<std::uint32_t>(index), place, node.name});
}

}  // namespace palpate::gltf
