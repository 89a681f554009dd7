#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/gltf/accessor_reader.h"
#include "engine/math/vector.h"

namespace palpate::gltf {

// The places, in the node's frame, where EXT_mesh_gpu_instancing repeats a mesh. `attributes` names its
// accessors.
std::vector<DMat4> read_gpu_instances(const std::map<std::string, int>& attributes,
                                      AccessorReader& accessors);

// How many they are, without reading them.
std::uint64_t count_gpu_instances(const std::map<std::string, int>& attributes,
                                  const AccessorReader& accessors);

}  // namespace palpate::gltf
