#pragma once

#include <array>
#include <cstddef>
#include <set>

#include "engine/gltf/gltf_scene.h"
#include "engine/math/box.h"

namespace palpate::test {

// What a baked scene holds, counted in a way that knows nothing of the reader.
struct WeldedScene {
  std::size_t triangles = 0;
  std::set<std::array<float, 3>> vertices;  // equal in single precision: one vertex
  Box box;
};

WeldedScene weld(const GltfScene& scene);

}  // namespace palpate::test
