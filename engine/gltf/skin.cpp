#include "engine/gltf/skin.h"

#include <string>
#include <utility>

#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

constexpr std::uint32_t kJointsInSet = 4;

DMat4 matrix_from(const double* column_major) {
  DMat4 matrix(1.0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) matrix[column][row] = column_major[4 * column + row];
  }
  return matrix;
}

// JOINTS_n and WEIGHTS_n.
struct InfluenceSet {
  AttributeTable joints;
  AttributeTable weights;
};

std::vector<InfluenceSet> read_influences(const PrimitiveSource& source, std::size_t vertices) {
  std::vector<InfluenceSet> sets;
  for (std::size_t n = 0; source.has(sentence("JOINTS_", n)) && source.has(sentence("WEIGHTS_", n)); ++n) {
    InfluenceSet set{source.table(sentence("JOINTS_", n), kJointsInSet),
                     source.table(sentence("WEIGHTS_", n), kJointsInSet)};
    if (set.joints.rows() != vertices || set.weights.rows() != vertices)
      fail(ErrorCode::kBadFormat, "JOINTS_", n, " and WEIGHTS_", n, " have ", set.joints.rows(), " and ",
           set.weights.rows(), " elements for ", vertices, " vertices");
    sets.push_back(std::move(set));
  }
  if (sets.empty()) fail(ErrorCode::kBadFormat, "a skinned primitive has no JOINTS_0 and WEIGHTS_0");
  return sets;
}

}  // namespace

Skin::Skin(int index, const GltfDocument& document, const NodeTree& tree, AccessorReader& accessors) {
  const std::vector<tinygltf::Skin>& skins = document.model.skins;
  if (index < 0 || static_cast<std::size_t>(index) >= skins.size())
    fail(ErrorCode::kBadFormat, "skin ", index, " does not exist");
  within("skin", static_cast<std::size_t>(index), [&] {
    const tinygltf::Skin& skin = skins[static_cast<std::size_t>(index)];
    AttributeTable inverse_bind{16, {}};
    if (skin.inverseBindMatrices >= 0) {
      inverse_bind = accessors.table(skin.inverseBindMatrices, 16);
      if (inverse_bind.rows() < skin.joints.size())
        fail(ErrorCode::kBadFormat, inverse_bind.rows(), " inverse bind matrices for ", skin.joints.size(),
             " joints");
    }
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const DMat4& scene_from_joint = tree.scene_from_node(skin.joints[i]);
      scene_from_bind_.push_back(inverse_bind.values.empty()
                                     ? scene_from_joint
                                     : scene_from_joint * matrix_from(inverse_bind.row(i)));
    }
    if (scene_from_bind_.empty()) fail(ErrorCode::kBadFormat, "it has no joints");
  });
}

const DMat4& Skin::joint(double number) const {
  // In double, so that nothing out of range is ever converted to an integer.
  if (!(number >= 0.0 && number < static_cast<double>(scene_from_bind_.size())))
    fail(ErrorCode::kBadFormat, "joint ", number, " is past the last joint ", scene_from_bind_.size() - 1);
  return scene_from_bind_[static_cast<std::size_t>(number)];
}

std::vector<DMat4> Skin::blend(const PrimitiveSource& source, std::size_t vertices,
                               const VertexSelection& selection) const {
  const std::vector<InfluenceSet> sets = read_influences(source, vertices);
  std::vector<DMat4> matrices;
  matrices.reserve(selection.size());
  for (std::size_t i = 0; i < selection.size(); ++i) {
    DMat4 sum(0.0);
    double total = 0.0;
    for (const InfluenceSet& set : sets) {
      for (std::uint32_t k = 0; k < kJointsInSet; ++k) {
        const double weight = set.weights.row(selection[i])[k];
        if (weight == 0.0) continue;  // its joint may be anything
        sum += weight * joint(set.joints.row(selection[i])[k]);
        total += weight;
      }
    }
    // Quantized weights do not quite sum to one; a vertex without any follows the first joint.
    matrices.push_back(total == 0.0 ? scene_from_bind_.front() : sum / total);
  }
  return matrices;
}

void Skin::apply(const PrimitiveSource& source, std::size_t vertices, const VertexSelection& selection,
                 std::vector<DVec3>& positions, std::vector<TriangleIndices>& triangles) const {
  const std::vector<DMat4> matrices = blend(source, vertices, selection);
  std::vector<bool> mirrored(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i] = DVec3(matrices[i] * glm::dvec4(positions[i], 1.0));
    mirrored[i] = glm::determinant(DMat3(matrices[i])) < 0.0;
  }
  for (TriangleIndices& triangle : triangles) {
    const int votes = int{mirrored[triangle[0]]} + int{mirrored[triangle[1]]} + int{mirrored[triangle[2]]};
    if (votes >= 2) std::swap(triangle[1], triangle[2]);
  }
}

}  // namespace palpate::gltf
