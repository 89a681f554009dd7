#include "engine/gltf/node_tree.h"

#include "engine/gltf/load_error.h"
#include "engine/gltf/node_transform.h"
#include "engine/math/finite.h"

namespace palpate::gltf {

NodeTree::NodeTree(const GltfDocument& document, const GltfLimits& limits)
    : document_(document),
      parents_(document.model.nodes.size(), -1),
      scene_from_node_(document.model.nodes.size(), DMat4(1.0)) {
  link_parents();
  place(limits);
}

void NodeTree::link_parents() {
  const auto count = static_cast<int>(parents_.size());
  for (int parent = 0; parent < count; ++parent) {
    for (const int child : node(parent).children) {
      if (child >= count) fail(ErrorCode::kBadFormat, "node ", parent, ": child ", child, " does not exist");
      int& known = parents_[static_cast<std::size_t>(child)];
      if (known >= 0)
        fail(ErrorCode::kBadFormat, "node ", child, " has two parents, ", known, " and ", parent);
      known = parent;
    }
  }
}

// Level by level from the roots. With one parent a node, a cycle is what the roots do not reach.
void NodeTree::place(const GltfLimits& limits) {
  std::vector<int> level = roots();
  std::size_t placed = 0;
  for (std::uint32_t depth = 1; !level.empty(); ++depth) {
    if (depth > limits.max_depth)
      fail(ErrorCode::kLimit, "node ", level.front(), " lies deeper than ", limits.max_depth, " nodes");
    std::vector<int> next;
    for (const int index : level) {
      const auto at = static_cast<std::size_t>(index);
      const DMat4 local = within("node", at, [&] { return parent_from_node(node(index)); });
      const int parent = parents_[at];
      scene_from_node_[at] = parent < 0 ? local : scene_from_node_[static_cast<std::size_t>(parent)] * local;
      next.insert(next.end(), node(index).children.begin(), node(index).children.end());
    }
    placed += level.size();
    level = std::move(next);
  }
  if (placed != parents_.size()) fail(ErrorCode::kBadFormat, "the nodes form a cycle");
}

const DMat4& NodeTree::scene_from_node(int index) const {
  if (index < 0 || static_cast<std::size_t>(index) >= scene_from_node_.size())
    fail(ErrorCode::kBadFormat, "node ", index, " does not exist");
  const DMat4& matrix = scene_from_node_[static_cast<std::size_t>(index)];
  if (!is_finite(matrix))
    fail(ErrorCode::kNonFinite, "node ", index, ": its place in the scene is not finite");
  return matrix;
}

std::vector<int> NodeTree::roots() const {
  std::vector<int> roots;
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    if (parents_[i] < 0) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

std::vector<int> NodeTree::walk(const std::vector<int>& roots) const {
  std::vector<bool> seen(parents_.size(), false);
  for (const int root : roots) {
    const auto at = static_cast<std::size_t>(root);
    if (at >= parents_.size()) fail(ErrorCode::kBadFormat, "node ", root, " does not exist");
    if (parents_[at] >= 0)
      fail(ErrorCode::kBadFormat, "node ", root, " is not a root, node ", parents_[at], " holds it");
    if (seen[at]) fail(ErrorCode::kBadFormat, "node ", root, " is there twice");
    seen[at] = true;
  }
  std::vector<int> order;
  std::vector<int> stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const int index = stack.back();
    stack.pop_back();
    order.push_back(index);
    stack.insert(stack.end(), node(index).children.rbegin(), node(index).children.rend());
  }
  return order;
}

}  // namespace palpate::gltf
