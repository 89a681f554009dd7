#pragma once

#include <vector>

#include "engine/gltf/accessor_reader.h"
#include "engine/gltf/vertex_selection.h"
#include "engine/math/vector.h"

namespace palpate::gltf {

// Moves `positions`, the selected ones of `vertices`, by the primitive's morph targets. Targets without a
// weight have weight zero.
void apply_morph_targets(const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                         AccessorReader& accessors, std::size_t vertices, const VertexSelection& selection,
                         std::vector<DVec3>& positions);

}  // namespace palpate::gltf
