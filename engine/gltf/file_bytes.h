#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "engine/gltf/load_budget.h"

namespace palpate::gltf {

// All bytes of a regular file. Throws kFileNotFound, kFileRead or kLimit.
std::vector<std::byte> read_file_bytes(const std::filesystem::path& path, LoadBudget& budget);

}  // namespace palpate::gltf
