// The bound on the stiffness of all springs together.
#include "engine/contact/stiffness_cap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "engine/math/symmetric_eigenvalue.h"

namespace palpate {
namespace {

constexpr SpringLaw kLaw{500.0, 0.01};

// A rotation times a diagonal matrix times the rotation's transpose.
DMat3 turned(const DVec3& eigenvalues, const DMat3& rotation) {
  return rotation * DMat3(eigenvalues.x, 0, 0, 0, eigenvalues.y, 0, 0, 0, eigenvalues.z) *
         glm::transpose(rotation);
}

TEST(Eigenvalue, IsThatTheMatrixIsMadeFrom) {
  constexpr unsigned kSeed = 5;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    const DQuat turn = glm::normalize(DQuat(any(random), any(random), any(random), any(random) + 1e-9));
    DVec3 values(any(random), any(random), any(random));
    if (i % 3 == 1) values.y = values.x;                                // double
    if (i % 3 == 2) values = DVec3(values.x * 1e-9, 0.0, any(random));  // far apart
    const double largest = std::max({values.x, values.y, values.z});
    EXPECT_NEAR(largest_eigenvalue(turned(values, glm::mat3_cast(turn))), largest, 1e-14);
  }
}

TEST(Eigenvalue, OfSpecialMatrices) {
  EXPECT_EQ(largest_eigenvalue(DMat3(0.0)), 0.0);
  EXPECT_EQ(largest_eigenvalue(DMat3(3.0)), 3.0);
  EXPECT_EQ(largest_eigenvalue(DMat3(-1, 0, 0, 0, -2, 0, 0, 0, -3)), -1.0);
  EXPECT_NEAR(largest_eigenvalue(DMat3(1, 1, 1, 1, 1, 1, 1, 1, 1)), 3.0, 1e-15);
  EXPECT_NEAR(largest_eigenvalue(DMat3(0, 1e200, 0, 1e200, 0, 0, 0, 0, 0)), 1e200, 1e186);
}

SpringContact pressing(const DVec3& direction, double distance, double weight = 1.0) {
  return {{}, glm::normalize(direction), distance, weight};
}

TEST(Cap, LeavesAloneWhatIsSofter) {
  StiffnessCap cap;
  EXPECT_EQ(cap.scale(1000.0), 1.0);
  cap.add(pressing({0, 0, 1}, 0.002), kLaw);
  EXPECT_EQ(cap.scale(1000.0), 1.0);
  EXPECT_EQ(cap.scale(0.0), 1.0) << "0 is no cap";
}

TEST(Cap, BoundsParallelSpringsButNotOpposedDirectionsTogether) {
  StiffnessCap parallel, around;
  for (int i = 0; i < 4; ++i) parallel.add(pressing({0, 0, i % 2 ? 1.0 : -1.0}, 0.002), kLaw);
  EXPECT_DOUBLE_EQ(parallel.scale(1000.0), 0.5);
  for (int i = 0; i < 3; ++i) around.add(pressing(DVec3(i == 0, i == 1, i == 2), 0.002), kLaw);
  EXPECT_EQ(around.scale(500.0), 1.0) << "each direction is as stiff as one spring";
}

TEST(Cap, CountsAPlateauOnce) {
  StiffnessCap cap;
  for (int i = 0; i < 4; ++i) cap.add(pressing({1, 1, 0}, 0.002, 0.25), kLaw);
  EXPECT_EQ(cap.scale(500.0 * (1.0 + 1e-12)), 1.0);
  EXPECT_DOUBLE_EQ(cap.scale(250.0), 0.5);
}

TEST(Cap, IsContinuousWhereASpringBegins) {
  double last = 1.0;
  for (int i = 0; i <= 3000; ++i) {
    StiffnessCap cap;
    cap.add(pressing({0, 0, 1}, 0.001), kLaw);
    cap.add(pressing({0, 1, 1}, 0.011 - 1e-6 * i), kLaw);
    const double scale = cap.scale(500.0);
    EXPECT_LE(scale, last * (1.0 + 1e-12));
    EXPECT_LT(last - scale, 0.002) << "at step " << i;
    last = scale;
  }
  EXPECT_LT(last, 0.6);
}

}  // namespace
}  // namespace palpate
