#pragma once

#include <cstdint>

namespace palpate {

// Limits that a file must keep before memory is taken for it.
struct GltfLimits {
  std::uint64_t max_file_bytes =
      4ull << 30;  // the file, its external buffers and what compressed buffers unpack to
  std::uint64_t max_triangles = 100'000'000;  // instances counted each time
  std::uint32_t max_nodes = 1'000'000;        // nodes of the file, and instances of the scene
  std::uint32_t max_depth = 1'000;            // nodes from a root down to a leaf
};

struct GltfOptions {
  int scene = -1;          // −1: the file's default scene
  bool hierarchy = false;  // read GltfScene::nodes, too
  GltfLimits limits;
};

}  // namespace palpate
