#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/mesh/triangle_soup.h"

namespace palpate::gltf {

// Which vertices of a primitive's accessors its soup keeps: all, or, where many primitives share one long
// accessor, only those that the triangles use. Never more than three a triangle.
class VertexSelection {
 public:
  // Renumbers the corners of `triangles`, which are below `vertices`, to the selection.
  VertexSelection(std::size_t vertices, std::vector<TriangleIndices>& triangles);

  std::size_t size() const { return all_ ? vertices_ : used_.size(); }
  std::size_t operator[](std::size_t i) const { return all_ ? i : used_[i]; }

 private:
  std::size_t vertices_;
  bool all_;
  std::vector<std::uint32_t> used_;  // ascending
};

}  // namespace palpate::gltf
