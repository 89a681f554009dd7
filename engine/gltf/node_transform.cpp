#include "engine/gltf/node_transform.h"

#include <cmath>
#include <vector>

#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

constexpr double kAffineTolerance = 1e-6;  // of the last row: exporters write single precision

void check_size(const std::vector<double>& numbers, std::size_t size, const char* name) {
  if (!numbers.empty() && numbers.size() != size)
    fail(ErrorCode::kBadFormat, '"', name, "\" has ", numbers.size(), " numbers instead of ", size);
}

DMat4 affine_from(const std::vector<double>& column_major) {
  DMat4 matrix(1.0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      const int at = 4 * column + row;
      const double number = column_major[static_cast<std::size_t>(at)];
      if (row < 3) {
        matrix[column][row] = number;
      } else if (std::abs(number - (column == 3 ? 1.0 : 0.0)) > kAffineTolerance) {
        fail(ErrorCode::kBadFormat, "\"matrix\" has a last row that is not 0 0 0 1");
      }
    }
  }
  return matrix;
}

DVec3 vector_from(const std::vector<double>& numbers, const DVec3& otherwise) {
  return numbers.empty() ? otherwise : DVec3(numbers[0], numbers[1], numbers[2]);
}

}  // namespace

DMat4 compose(const DVec3& translation, const DQuat& rotation, const DVec3& scale) {
  const double length = glm::length(rotation);
  if (!(length > 0.0) || !std::isfinite(length))
    fail(ErrorCode::kBadFormat, "a rotation is a quaternion of length ", length);
  DMat4 matrix = glm::mat4_cast(rotation / length);
  for (int axis = 0; axis < 3; ++axis) matrix[axis] *= scale[axis];
  matrix[3] = glm::dvec4(translation, 1.0);
  return matrix;
}

DMat4 parent_from_node(const tinygltf::Node& node) {
  check_size(node.matrix, 16, "matrix");
  check_size(node.translation, 3, "translation");
  check_size(node.rotation, 4, "rotation");
  check_size(node.scale, 3, "scale");
  if (!node.matrix.empty()) return affine_from(node.matrix);
  DQuat rotation(1.0, 0.0, 0.0, 0.0);
  if (!node.rotation.empty())
    rotation = DQuat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
  return compose(vector_from(node.translation, DVec3(0.0)), rotation, vector_from(node.scale, DVec3(1.0)));
}

}  // namespace palpate::gltf
