#include "engine/gltf/rigid_part.h"

#include <algorithm>
#include <cmath>

namespace palpate {
namespace {

// Below this share of the longest column a column, or what of it is new, is taken for nothing.
constexpr double kNothing = 1e-12;

double largest_entry(const DMat3& matrix) {
  double largest = 0.0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
  }
  return largest;
}

// A unit vector at right angles to a unit vector.
DVec3 any_across(const DVec3& unit) {
  const DVec3 size = glm::abs(unit);
  const DVec3 away = size.x <= size.y && size.x <= size.z ? DVec3(1.0, 0.0, 0.0)
                     : size.y <= size.z                   ? DVec3(0.0, 1.0, 0.0)
                                                          : DVec3(0.0, 0.0, 1.0);
  return glm::normalize(glm::cross(unit, away));
}

// `vector` without its part along `unit`, twice, so that it is across to the last digit.
DVec3 across(const DVec3& vector, const DVec3& unit) {
  DVec3 rest = vector - glm::dot(vector, unit) * unit;
  rest -= glm::dot(rest, unit) * unit;
  return rest;
}

bool is_nothing(const DVec3& vector) {
  return !(glm::length(vector) > kNothing);
}

// Along the first column; if that is nothing, such that the two others need not be turned.
DVec3 first_axis(const DMat3& columns) {
  if (!is_nothing(columns[0])) return glm::normalize(columns[0]);
  const DVec3 across_both = glm::cross(columns[1], columns[2]);
  if (!is_nothing(across_both)) return glm::normalize(across_both);
  for (const DVec3& column : {columns[1], columns[2]}) {
    if (!is_nothing(column)) return any_across(glm::normalize(column));
  }
  return {1.0, 0.0, 0.0};
}

DVec3 second_axis(const DMat3& columns, const DVec3& first) {
  const DVec3 rest = across(columns[1], first);
  if (!is_nothing(rest)) return glm::normalize(across(glm::normalize(rest), first));
  const DVec3 other = across(columns[2], first);
  if (!is_nothing(other)) return glm::normalize(glm::cross(glm::normalize(other), first));
  return any_across(first);
}

}  // namespace

Pose rigid_part(const DMat4& matrix) {
  Pose part;
  part.translation = DVec3(matrix[3]);
  const DMat3 linear(matrix);
  const double largest = largest_entry(linear);
  if (!(largest > 0.0)) return part;
  const DMat3 columns = linear / largest;  // so that no square overflows or vanishes
  const DVec3 first = first_axis(columns);
  const DVec3 second = second_axis(columns, first);
  part.rotation = DMat3(first, second, glm::cross(first, second));
  return part;
}

DMat4 relative_to(const Pose& part, const DMat4& matrix) {
  const DMat3 back = glm::transpose(part.rotation);
  DMat4 relative(back * DMat3(matrix));
  relative[3] = glm::dvec4(back * (DVec3(matrix[3]) - part.translation), 1.0);
  return relative;
}

}  // namespace palpate
