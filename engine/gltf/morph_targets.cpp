#include "engine/gltf/morph_targets.h"

#include <algorithm>

#include "engine/gltf/load_error.h"

namespace palpate::gltf {

void apply_morph_targets(const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                         AccessorReader& accessors, std::size_t vertices, const VertexSelection& selection,
                         std::vector<DVec3>& positions) {
  const std::size_t count = std::min(weights.size(), primitive.targets.size());
  for (std::size_t target = 0; target < count; ++target) {
    const auto found = primitive.targets[target].find("POSITION");
    if (weights[target] == 0.0 || found == primitive.targets[target].end()) continue;
    within("morph target", target, [&] {
      const AttributeTable offsets = accessors.table(found->second, 3);
      if (offsets.rows() != vertices)
        fail(ErrorCode::kBadFormat, offsets.rows(), " offsets for ", vertices, " vertices");
      for (std::size_t i = 0; i < selection.size(); ++i) {
        const double* offset = offsets.row(selection[i]);
        positions[i] += weights[target] * DVec3(offset[0], offset[1], offset[2]);
      }
    });
  }
}

}  // namespace palpate::gltf
