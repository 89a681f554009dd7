#pragma once

#include <cstddef>
#include <vector>

#include "engine/gltf/gltf_document.h"
#include "engine/math/vector.h"

namespace palpate::gltf {

// The nodes of a file, checked to be trees: no cycle, no node with two parents, none too deep.
class NodeTree {
 public:
  NodeTree(const GltfDocument& document, const GltfLimits& limits);

  // Throws kBadFormat if there is no such node, kNonFinite if its transform is out of range.
  const DMat4& scene_from_node(int index) const;

  int parent(int index) const { return parents_[static_cast<std::size_t>(index)]; }  // −1: a root
  std::vector<int> roots() const;

  // The nodes below and including `roots`, each once, parents before children and siblings in order. Throws
  // kBadFormat if one of them is not a root or is there twice.
  std::vector<int> walk(const std::vector<int>& roots) const;

 private:
  void link_parents();
  void place(const GltfLimits& limits);
  const tinygltf::Node& node(int index) const {
    return document_.model.nodes[static_cast<std::size_t>(index)];
  }

  const GltfDocument& document_;
  std::vector<int> parents_;  // −1: a root
  std::vector<DMat4> scene_from_node_;
};

}  // namespace palpate::gltf
