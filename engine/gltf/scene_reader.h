#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "engine/gltf/accessor_reader.h"
#include "engine/gltf/gltf_scene.h"
#include "engine/gltf/mesh_reader.h"
#include "engine/gltf/node_tree.h"

namespace palpate::gltf {

// Collects the meshes and instances of one scene of a document.
class SceneReader {
 public:
  SceneReader(const GltfDocument& document, BufferStore& buffers, LoadBudget& budget,
              const GltfOptions& options);

  GltfScene read() &&;

 private:
  // Nodes share a soup if they have the same mesh, skin (−1: none) and morph weights.
  using SoupKey = std::tuple<int, int, std::vector<double>>;

  std::vector<int> scene_roots();
  void read_node(int index);
  void read_hierarchy(const std::vector<int>& order);
  GltfNode node_of(int index) const;
  std::uint32_t soup_of(const SoupKey& key);
  SoupKey key_of(const tinygltf::Node& node) const;
  std::vector<DMat4> places_of(int index, std::uint64_t triangles);

  const GltfDocument& document_;
  LoadBudget& budget_;
  int wanted_scene_;
  bool hierarchy_;
  AccessorReader accessors_;
  NodeTree tree_;
  GltfScene scene_;
  MeshReader meshes_;
  std::map<SoupKey, std::uint32_t> soups_;
};

}  // namespace palpate::gltf
