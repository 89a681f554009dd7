#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace palpate::gltf {

// The two parts of a file, as views into its bytes.
struct Container {
  std::string_view json;
  bool has_chunk = false;
  std::span<const std::byte> chunk;  // the binary chunk of a .glb, padding included
};

// Tells .glb from .gltf by its first bytes, whatever the file's name.
Container open_container(std::span<const std::byte> bytes);

}  // namespace palpate::gltf
