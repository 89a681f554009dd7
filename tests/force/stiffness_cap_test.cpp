// The bound on the stiffness of all springs together.
#include "engine/contact/stiffness_cap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "tests/support/symmetric_eigenvalue.h"

namespace palpate {
namespace {

constexpr double kCutoff = 0.01;      // m
constexpr double kStiffness = 500.0;  // N/m
constexpr SpringLaw kLaw{kStiffness, kCutoff};

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

// Springs that keep place and direction while the tool is moved; those beyond the cutoff are unknown, as in a
// scene.
class Springs {
 public:
  Springs(std::vector<SpringContact> springs, double most, SpringLaw law = kLaw)
      : springs_(std::move(springs)), law_(law), most_(most) {}

  std::vector<DVec3> forces_at(const DVec3& moved) {
    std::vector<DVec3> forces;
    cap_.clear();
    for (SpringContact spring : springs_) {
      spring.distance += glm::dot(spring.direction, moved);
      if (spring.distance >= kCutoff) continue;
      cap_.add(spring, law_);
      forces.push_back(spring_force(spring, law_));
    }
    const std::span<const double> shares = cap_.shares(most_);
    for (std::size_t i = 0; i < forces.size(); ++i) forces[i] *= shares[i];
    return forces;
  }

  DVec3 force_at(const DVec3& moved) {
    DVec3 sum(0.0);
    for (const DVec3& force : forces_at(moved)) sum += force;
    return sum;
  }

  // Against motion along a unit vector, N/m.
  double stiffness_at(const DVec3& moved, const DVec3& along) {
    constexpr double kStep = 1e-5 * kCutoff;
    return glm::dot(force_at(moved - kStep * along) - force_at(moved + kStep * along), along) / (2.0 * kStep);
  }

  std::vector<SpringContact>& list() { return springs_; }
  double most() const { return most_; }
  int steps() const { return cap_.steps(); }

 private:
  std::vector<SpringContact> springs_;
  SpringLaw law_;
  double most_;
  StiffnessCap cap_;
};

SpringContact pressing(const DVec3& direction, double distance, double weight = 1.0) {
  return {{}, glm::normalize(direction), distance, weight};
}

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) { std::printf("seed %u\n", seed); }

  double between(double low, double high) { return low + (high - low) * any_(random_); }
  double spread(double low, double high) { return low * std::pow(high / low, any_(random_)); }
  DVec3 direction() {
    std::normal_distribution<double> normal;
    return glm::normalize(DVec3(normal(random_), normal(random_), normal(random_)) + DVec3(1e-9));
  }
  // Within the cutoff's sphere around the origin.
  DVec3 place() { return between(0.0, kCutoff) * direction(); }

  // Around all sides, in a cone, in a groove, or in a plane; some deep, some not begun.
  Springs springs() {
    const int count = static_cast<int>(spread(1.0, 41.0));
    const int kind = static_cast<int>(between(0.0, 4.0));
    const DVec3 axis = direction();
    std::vector<SpringContact> springs;
    for (int i = 0; i < count; ++i) {
      DVec3 u = direction();
      if (kind == 1) u = glm::normalize(axis + 0.2 * u);
      if (kind == 2) u = glm::normalize((i % 2 ? 1.0 : -1.0) * axis + 0.1 * u);
      if (kind == 3) u = glm::normalize(u - glm::dot(u, axis) * axis);
      springs.push_back({{}, u, between(-2.5, 1.5) * kCutoff, spread(1e-3, 1.0)});
    }
    return {springs, kStiffness * spread(1e-3, 1e2)};
  }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> any_{0.0, 1.0};
};

// Of two places of the tool: the force changes by no more than the cap times the way, and never helps it on.
// Far apart and near, so that no jump and no steep place is missed.
TEST(Cap, BoundsTheStiffnessOfAnySprings) {
  Dice dice(17);
  double stiffest = 0.0;
  int most_steps = 0;
  for (int i = 0; i < 20000; ++i) {
    Springs springs = dice.springs();
    const DVec3 one = dice.place(), way = dice.spread(1e-6, 2.0) * kCutoff * dice.direction();
    const DVec3 change = springs.force_at(one + way) - springs.force_at(one);
    most_steps = std::max(most_steps, springs.steps());
    const double allowed = springs.most() * glm::length(way), rounding = 1e-10 * kStiffness * kCutoff;
    ASSERT_LE(glm::length(change), allowed * (1.0 + 1e-9) + rounding) << i;
    ASSERT_LE(glm::dot(change, way), rounding * glm::length(way)) << i << ": it helps the hand on";
    stiffest = std::max(stiffest, glm::length(change) / allowed);
  }
  std::printf("stiffest %.4f of the cap, at most %d steps of Newton\n", stiffest, most_steps);
  EXPECT_GT(stiffest, 0.95) << "and not by being soft";
  EXPECT_LE(most_steps, 32);
}

// The tangent stiffness in the stiffest direction.
TEST(Cap, BoundsTheStiffestDirection) {
  Dice dice(18);
  constexpr double kStep = 1e-5 * kCutoff;
  for (int i = 0; i < 3000; ++i) {
    Springs springs = dice.springs();
    const DVec3 place = dice.place();
    DMat3 stiffness;
    for (int axis = 0; axis < 3; ++axis) {
      DVec3 step(0.0);
      step[axis] = kStep;
      stiffness[axis] = (springs.force_at(place - step) - springs.force_at(place + step)) / (2.0 * kStep);
    }
    const DMat3 even = 0.5 * (stiffness + glm::transpose(stiffness));
    EXPECT_LE(largest_eigenvalue(even), springs.most() * (1.0 + 1e-6)) << i;
    EXPECT_LE(largest_eigenvalue(-even), 1e-6 * springs.most()) << i;
  }
}

// The force is linear in pieces along a line: where it is, the trapezoid is exact.
double work_along(Springs& springs, const DVec3& from, const DVec3& to, int halvings = 40) {
  const DVec3 first = springs.force_at(from), last = springs.force_at(to);
  const DVec3 middle = 0.5 * (from + to), mean = 0.5 * (first + last);
  const double bend = glm::length(springs.force_at(middle) - mean);
  if (halvings == 0 || bend <= 1e-12 * kStiffness * kCutoff) return glm::dot(mean, to - from);
  return work_along(springs, from, middle, halvings - 1) + work_along(springs, middle, to, halvings - 1);
}

TEST(Cap, GivesNoEnergyOnClosedPaths) {
  Dice dice(19);
  for (int i = 0; i < 100; ++i) {
    Springs springs = dice.springs();
    const DVec3 a = dice.place(), b = dice.place(), c = dice.place();
    const double energy = work_along(springs, a, b) + work_along(springs, b, c) + work_along(springs, c, a);
    EXPECT_NEAR(energy, 0.0, 1e-9 * kStiffness * kCutoff * kCutoff) << i;
  }
}

TEST(Cap, SolvesWhatItSays) {
  Dice dice(20);
  for (int i = 0; i < 5000; ++i) {
    Springs springs = dice.springs();
    const DVec3 place = dice.place();
    const std::vector<DVec3> forces = springs.forces_at(place);
    const DVec3 sum = springs.force_at(place);
    double pressure = 0.0;
    for (const DVec3& force : forces) pressure += glm::length(force);
    std::size_t next = 0;
    for (const SpringContact& spring : springs.list()) {
      const double compression = kCutoff - spring.distance - glm::dot(spring.direction, place);
      if (!(compression > 0.0)) continue;
      const double yielded = (glm::dot(spring.direction, sum) + pressure) / springs.most();
      const double pressed = std::clamp(compression - yielded, 0.0, 2.0 * kCutoff);
      const double most = kStiffness * spring.weight;
      EXPECT_NEAR(glm::dot(forces[next++], spring.direction), most * pressed, 1e-9 * most * kCutoff) << i;
    }
  }
}

TEST(Cap, LetsNoSpringPushMoreThanItDoesAlone) {
  Dice dice(21);
  for (int i = 0; i < 5000; ++i) {
    Springs capped = dice.springs();
    Springs free(capped.list(), 0.0);
    const DVec3 place = dice.place();
    const std::vector<DVec3> forces = capped.forces_at(place), alone = free.forces_at(place);
    for (std::size_t k = 0; k < forces.size(); ++k)
      ASSERT_LE(glm::length(forces[k]), glm::length(alone[k]) * (1.0 + 1e-12)) << i;
  }
}

TEST(Cap, DoesNotDependOnTheOrderOfSprings) {
  Dice dice(22);
  for (int i = 0; i < 2000; ++i) {
    Springs springs = dice.springs();
    const DVec3 force = springs.force_at(DVec3(0.0));
    std::reverse(springs.list().begin(), springs.list().end());
    EXPECT_LE(glm::length(springs.force_at(DVec3(0.0)) - force), 1e-10 * kStiffness * kCutoff) << i;
  }
}

TEST(Cap, DoesNotJumpWhereASpringGetsItsWeight) {
  Dice dice(23);
  for (int i = 0; i < 2000; ++i) {
    Springs springs = dice.springs();
    const DVec3 force = springs.force_at(DVec3(0.0));
    springs.list().push_back({{}, dice.direction(), -kCutoff, 1e-7});
    const double own = 1e-7 * kStiffness * 2.0 * kCutoff;
    EXPECT_LE(glm::length(springs.force_at(DVec3(0.0)) - force), 2.0 * own + 1e-12) << i;
  }
}

TEST(Cap, IsNoneWhereItIsNotPositive) {
  const std::vector<SpringContact> springs{pressing({0, 0, 1}, 0.002), pressing({0, 1, 1}, 0.004)};
  for (const double none : {0.0, -1.0}) {
    Springs free(springs, none);
    EXPECT_EQ(free.force_at(DVec3(0.0)), spring_force(springs[0], kLaw) + spring_force(springs[1], kLaw));
  }
}

TEST(Cap, PutsAFaceInSeriesWithHalfOfIt) {
  constexpr double kPressed = 0.008;  // m
  for (const double most : {50.0, 800.0, 1e6}) {
    for (const int count : {1, 4, 64}) {
      const std::vector<SpringContact> face(static_cast<std::size_t>(count),
                                            pressing({1, 2, 2}, kCutoff - kPressed));
      Springs springs(face, most);
      const double all = kStiffness * count;
      EXPECT_NEAR(glm::length(springs.force_at(DVec3(0.0))), kPressed / (1.0 / all + 2.0 / most), 1e-9);
    }
  }
}

TEST(Cap, CountsAPlateauOnce) {
  Springs one({pressing({1, 1, 0}, 0.002)}, 700.0);
  Springs four(std::vector<SpringContact>(4, pressing({1, 1, 0}, 0.002, 0.25)), 700.0);
  EXPECT_LT(glm::distance(one.force_at(DVec3(0.0)), four.force_at(DVec3(0.0))), 1e-12);
}

// The hand feels both faces of a groove.
TEST(Cap, IsReachedBetweenOppositeFaces) {
  constexpr double kMost = 800.0;
  Springs groove({pressing({0, 0, 1}, 0.004, 1e3), pressing({0, 0, -1}, 0.004, 1e3)}, kMost);
  EXPECT_LE(groove.stiffness_at(DVec3(0.0), {0, 0, 1}), kMost);
  EXPECT_GE(groove.stiffness_at(DVec3(0.0), {0, 0, 1}), 0.99 * kMost);
}

// Springs begin one after the other as the hand presses in.
TEST(Cap, GrowsWhileTheHandPressesIn) {
  std::vector<SpringContact> springs;
  for (int i = 0; i < 8; ++i) springs.push_back(pressing({0.1 * i, 0, 1}, kCutoff + 1e-4 * i));
  constexpr double kMost = 800.0, kStep = 1e-6;
  Springs floor(springs, kMost);
  double before = 0.0;
  for (int i = 1; i < 12000; ++i) {
    const double force = floor.force_at({0, 0, -kStep * i}).z;
    ASSERT_GE(force, before);
    ASSERT_LE(force - before, kMost * kStep * (1.0 + 1e-6));
    before = force;
  }
  EXPECT_GT(before, 0.3 * kMost * kCutoff);
}

// A wall that is pressed in deeper than it grows is as strong under the cap.
TEST(Cap, LetsAWallGrowToItsMost) {
  Springs wall({pressing({0, 0, 1}, kCutoff)}, 100.0);
  EXPECT_DOUBLE_EQ(wall.force_at({0, 0, -1.0}).z, kStiffness * 2.0 * kCutoff);
}

TEST(Cap, StaysFiniteForAbsurdStiffness) {
  const SpringLaw absurd{1e15, kCutoff};
  Springs springs({pressing({0, 0, 1}, 0.001), pressing({0.1, 0, 1}, 0.002), pressing({0, 0.1, 1}, -0.03)},
                  800.0, absurd);
  const DVec3 force = springs.force_at(DVec3(0.0));
  EXPECT_TRUE(std::isfinite(force.x + force.y + force.z));
  EXPECT_LE(glm::length(force), 800.0 * 0.05);
}

TEST(Cap, StaysFiniteForAbsurdCaps) {
  Dice dice(23);
  for (int i = 0; i < 5'000; ++i) {
    const double most = dice.spread(1e-290, 1e15);
    Springs springs(dice.springs().list(), most, {dice.spread(1e-6, 1e15), kCutoff});
    const DVec3 force = springs.force_at(DVec3(0.0));
    ASSERT_TRUE(std::isfinite(force.x + force.y + force.z)) << most;
    ASSERT_LE(glm::length(force), 4.0 * most * kCutoff * (1.0 + 1e-9)) << most;
  }
}

}  // namespace
}  // namespace palpate
