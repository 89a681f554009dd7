#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/gltf/collision_filter.h"
#include "engine/gltf/haptic_material.h"
#include "engine/gltf/load_tally.h"
#include "engine/math/vector.h"
#include "engine/mesh/triangle_soup.h"

namespace palpate {

// One occurrence of a mesh in the scene graph. Nodes that share a mesh share its triangles.
struct GltfInstance {
  std::uint32_t mesh;  // index into GltfScene::meshes
  std::uint32_t node;  // index in the file
  DMat4 scene_from_mesh{1.0};
  std::string name;  // the node's
};

// A node of the scene, with what it and its mesh say of touching it.
struct GltfNode {
  std::uint32_t index = 0;   // in the file
  std::int32_t parent = -1;  // into GltfScene::nodes; −1: a root
  std::string name;          // if it has none, its mesh's
  DMat4 scene_from_node{1.0};
  HapticMaterial material;
  bool moves = false;        // it or a node above has a motion
  bool solid = true;         // false: it detects, and does not touch
  std::int32_t filter = -1;  // into GltfScene::filters
};

// The geometry of one scene: triangles by mesh, and where each occurs. A mesh of the file that is skinned or
// morphed in several ways is here once for each.
struct GltfScene {
  std::vector<TriangleSoup> meshes;
  std::vector<GltfInstance> instances;
  std::vector<GltfNode> nodes;           // if GltfOptions::hierarchy: all, parents before children
  std::vector<CollisionFilter> filters;  // the same
  std::vector<std::string> notes;        // what was skipped, a sentence each
  LoadTally tally;
};

// Instances in one soup, in the frame that they are placed in. Mirrored ones have their winding turned.
TriangleSoup bake(const std::vector<TriangleSoup>& meshes, std::span<const GltfInstance> instances);

// All instances in one soup, in the scene's frame.
TriangleSoup bake(const GltfScene& scene);

}  // namespace palpate
