#pragma once

#include <cstdint>
#include <string>
#include <vector>

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

// The geometry of one scene: triangles by mesh, and where each occurs. A mesh of the file that is skinned or
// morphed in several ways is here once for each.
struct GltfScene {
  std::vector<TriangleSoup> meshes;
  std::vector<GltfInstance> instances;
  std::vector<std::string> notes;  // what was skipped, a sentence each
  LoadTally tally;
};

// All instances in one soup, in the scene's frame. Mirrored instances have their winding turned.
TriangleSoup bake(const GltfScene& scene);

}  // namespace palpate
