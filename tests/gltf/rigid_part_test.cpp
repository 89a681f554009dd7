#include "engine/gltf/rigid_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace palpate::test {
namespace {

constexpr std::uint64_t kSeed = 20;

double largest(const DMat3& matrix) {
  double found = 0.0;
  for (int i = 0; i < 9; ++i) found = std::max(found, std::abs(matrix[i / 3][i % 3]));
  return found;
}

// Rotations, scales of any sign and size, shears, and columns that are nothing.
class Matrices {
 public:
  DMat3 rotation() {
    return glm::mat3_cast(glm::normalize(DQuat(number() + 1.5, number(), number(), number())));
  }
  DVec3 scale() { return {number() + 2.0, number() + 2.0, number() + 2.0}; }  // positive
  DMat3 any() {
    DMat3 matrix;
    for (int i = 0; i < 9; ++i) matrix[i / 3][i % 3] = number();
    for (int column = 0; column < 3; ++column) {
      if (below(6) == 0) matrix[column] = DVec3(0.0);
      if (below(6) == 0) matrix[column] = matrix[(column + 1) % 3] * number();
    }
    return matrix * std::pow(10.0, 200.0 * number());
  }
  double number() { return std::uniform_real_distribution(-1.0, 1.0)(generator_); }
  std::uint64_t below(std::uint64_t count) { return generator_() % count; }

 private:
  std::mt19937_64 generator_{kSeed};
};

TEST(RigidPart, IsARotationAndTogetherWithTheRestTheMatrix) {
  RecordProperty("seed", std::to_string(kSeed));
  Matrices matrices;
  for (int i = 0; i < 20'000; ++i) {
    DMat4 matrix(matrices.any());
    matrix[3] = glm::dvec4(matrices.number(), 1e6 * matrices.number(), matrices.number(), 1.0);
    const Pose part = rigid_part(matrix);
    EXPECT_LT(largest(glm::transpose(part.rotation) * part.rotation - DMat3(1.0)), 1e-14) << i;
    EXPECT_NEAR(glm::determinant(part.rotation), 1.0, 1e-14) << i;
    EXPECT_EQ(part.translation, DVec3(matrix[3])) << i;
    const DMat4 rest = relative_to(part, matrix);
    EXPECT_EQ(DVec3(rest[3]), DVec3(0.0)) << i;
    const DMat3 linear(matrix);
    EXPECT_LE(largest(part.rotation * DMat3(rest) - linear), 1e-13 * largest(linear)) << i;
  }
}

TEST(RigidPart, OfATurnAndAScaleIsTheTurn) {
  RecordProperty("seed", std::to_string(kSeed));
  Matrices matrices;
  for (int i = 0; i < 5'000; ++i) {
    const DMat3 turn = matrices.rotation();
    DMat3 scaled = turn;
    const DVec3 scale = matrices.scale();
    for (int axis = 0; axis < 3; ++axis) scaled[axis] *= scale[axis];
    EXPECT_LT(largest(rigid_part(DMat4(scaled)).rotation - turn), 1e-14) << i;
    scaled[2] = -scaled[2];  // a mirror is in the rest
    EXPECT_LT(largest(rigid_part(DMat4(scaled)).rotation - turn), 1e-14) << i;
  }
}

TEST(RigidPart, OfNothingIsTheTranslationAlone) {
  DMat4 matrix(0.0);
  matrix[3] = glm::dvec4(1.0, 2.0, 3.0, 1.0);
  const Pose part = rigid_part(matrix);
  EXPECT_EQ(part.rotation, DMat3(1.0));
  EXPECT_EQ(part.translation, DVec3(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace palpate::test
