#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gltf/gltf_options.h"
#include "engine/gltf/haptic_properties.h"

namespace palpate::gltf {

struct BufferSource {
  std::uint64_t byte_length = 0;
  std::optional<std::string> uri;
};

enum class MeshoptMode { kAttributes, kTriangles, kIndices };

// EXT_meshopt_compression of a bufferView.
struct MeshoptBlock {
  int buffer = 0;
  std::uint64_t byte_offset = 0;
  std::uint64_t byte_length = 0;
  std::uint64_t byte_stride = 0;
  std::uint64_t count = 0;
  MeshoptMode mode = MeshoptMode::kAttributes;
  std::string filter;
};

// KHR_draco_mesh_compression of a primitive.
struct DracoBlock {
  int buffer_view = 0;
  std::map<std::string, int> attributes;  // Draco's unique ids
};

// What of a primitive tinygltf does not read, or would refuse: it wants a bufferView behind all indices,
// though sparse and Draco-compressed indices need none.
struct PrimitiveExtra {
  int indices = -1;
  std::optional<DracoBlock> draco;
};

// The parts of a glTF document that shape its geometry, types and ranges of numbers checked, references not
// yet.
struct GltfDocument {
  tinygltf::Model
      model;  // accessors, bufferViews, meshes, nodes, scenes, skins; materials with doubleSided alone
  std::vector<BufferSource> buffers;
  std::vector<std::optional<MeshoptBlock>> meshopt;           // by bufferView
  std::vector<std::vector<PrimitiveExtra>> primitive_extras;  // by mesh and primitive
  std::vector<std::map<std::string, int>> instancing;         // accessors of EXT_mesh_gpu_instancing, by node
  HapticProperties haptics;                                   // if GltfOptions::hierarchy
};

GltfDocument read_document(std::string_view json_text, const GltfOptions& options);

}  // namespace palpate::gltf
