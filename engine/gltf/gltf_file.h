#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/math/vector.h"
#include "engine/mesh/triangle_soup.h"

namespace palpate {

// Limits that a file must keep before memory is taken for it.
struct GltfLimits {
  std::uint64_t max_file_bytes = 4ull << 30;
  std::uint64_t max_triangles = 100'000'000;  // instances counted each time
  std::uint32_t max_nodes = 1'000'000;
  std::uint32_t max_depth = 1'000;
};

struct GltfOptions {
  int scene = -1;  // −1: the file's default scene
  GltfLimits limits;
};

// One occurrence of a mesh in the scene graph. Nodes that share a mesh share its triangles.
struct GltfInstance {
  std::uint32_t mesh;         // index into GltfScene::meshes
  std::uint32_t node;         // index in the file
  DMat4 scene_from_mesh{1.0};
  std::string name;           // the node's
};

// The geometry of one scene: triangles by mesh, and where each occurs.
struct GltfScene {
  std::vector<TriangleSoup> meshes;
  std::vector<GltfInstance> instances;
  std::vector<std::string> notes;  // what was skipped, a sentence each
};

// Reads the geometry of a .gltf or .glb file: never an image, an animation or a texture. External buffers come only
// from the file's own folder or below.
// Errors: kFileNotFound, kFileRead, kBadFormat, kUnsupported, kUnsafePath, kLimit, kNonFinite, kNoTriangles.
Result<GltfScene> read_gltf_file(const std::filesystem::path& path, const GltfOptions& options);

// The same from bytes. External buffers come from `folder`; if that is empty there are none. `name` is what errors
// call it.
Result<GltfScene> read_gltf_bytes(std::span<const std::byte> bytes, const std::string& name,
                                  const std::filesystem::path& folder, const GltfOptions& options);

// All instances in one soup, in the scene's frame. Mirrored instances have their winding turned.
TriangleSoup bake(const GltfScene& scene);

}  // namespace palpate
