#pragma once

#include <vector>

#include "engine/gltf/accessor_reader.h"
#include "engine/gltf/node_tree.h"
#include "engine/gltf/primitive_source.h"
#include "engine/gltf/vertex_selection.h"
#include "engine/math/vector.h"

namespace palpate::gltf {

// The joints of a skin as the nodes' transforms at rest place them (glTF 2.0, section 3.7.3).
class Skin {
 public:
  Skin(int index, const GltfDocument& document, const NodeTree& tree, AccessorReader& accessors);

  // Moves `positions`, the selected ones of `vertices`, into the scene's frame, and turns the triangles whose
  // corners were mirrored by it.
  void apply(const PrimitiveSource& source, std::size_t vertices, const VertexSelection& selection,
             std::vector<DVec3>& positions, std::vector<TriangleIndices>& triangles) const;

 private:
  std::vector<DMat4> blend(const PrimitiveSource& source, std::size_t vertices,
                           const VertexSelection& selection) const;
  const DMat4& joint(double number) const;

  std::vector<DMat4> scene_from_bind_;  // by joint
};

}  // namespace palpate::gltf
