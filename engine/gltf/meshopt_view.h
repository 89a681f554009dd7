#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/gltf/gltf_document.h"
#include "engine/gltf/load_budget.h"

namespace palpate::gltf {

// Decompresses a bufferView of EXT_meshopt_compression, its filter included.
std::vector<std::byte> decode_meshopt(const MeshoptBlock& block, std::span<const std::byte> compressed,
                                      LoadBudget& budget);

}  // namespace palpate::gltf
