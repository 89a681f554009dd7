// Damping and friction of one spring: what they may do to a hand.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "engine/contact/damping.h"
#include "engine/contact/friction.h"

namespace palpate {
namespace {

constexpr double kCutoff = 0.004, kStiffness = 800.0, kStep = 0.001;
constexpr SpringLaw kLaw{kStiffness, kCutoff, 2.0, 0.4};

double damping_at(double distance, double closing_speed) {
  return damping_force({{}, {0.0, 0.0, 1.0}, distance, 1.0}, closing_speed, kLaw);
}

TEST(Damping, IsOnlyWhileClosing) {
  EXPECT_EQ(damping_at(0.001, -0.3), 0.0);
  EXPECT_EQ(damping_at(0.001, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(damping_at(0.001, 0.3), 0.6);
}

TEST(Damping, FadesInAtTheCutoff) {
  EXPECT_EQ(damping_at(kCutoff, 0.3), 0.0);
  double last = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double force = damping_at(kCutoff * (1.0 - 0.0002 * i), 0.3);
    EXPECT_GE(force, last);
    EXPECT_LT(force - last, 0.6 * 0.005) << "no jump";
    last = force;
  }
  EXPECT_DOUBLE_EQ(last, 0.6);
}

TEST(Damping, IsSharedByAPlateau) {
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += damping_force({{}, {0.0, 0.0, 1.0}, 0.001, 0.25}, 0.3, kLaw);
  EXPECT_DOUBLE_EQ(sum, damping_at(0.001, 0.3));
}

// What a hand gets back from closed cycles in and out of a spring, each force held for one step as a device
// holds it.
double energy_of_cycles(double damping) {
  const SpringLaw law{kStiffness, kCutoff, damping};
  double energy = 0.0, before = kCutoff;
  for (int i = 0; i < 4000; ++i) {
    const auto distance_at = [](int step) { return 0.0022 + 0.0018 * std::cos(0.01 * M_PI * step); };
    const double distance = distance_at(i);
    const SpringContact contact{{}, {0.0, 0.0, 1.0}, distance, 1.0};
    const double force =
        spring_force(contact, law).z + damping_force(contact, (before - distance) / kStep, law);
    EXPECT_GE(force, 0.0) << "a spring never pulls";
    energy += force * (distance_at(i + 1) - distance);
    before = distance;
  }
  return energy;
}

// A spring whose force is held gives k/2 times the squared steps away; damping takes it back from b = k T on.
TEST(Damping, TakesWhatHoldingTheForceGives) {
  const double without = energy_of_cycles(0.0), with = energy_of_cycles(1.5 * kStiffness * kStep);
  std::printf("energy of 20 cycles: %.3e J without damping, %.3e J with b = 1.5 k T\n", without, with);
  EXPECT_GT(without, 0.0);
  EXPECT_LT(with, 0.0);
}

TEST(Friction, OnlyTakesEnergyAndNeverMoreThanCoulombs) {
  constexpr unsigned kSeed = 11;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> any(-0.2, 0.2), positive(0.0, 5.0);
  for (int i = 0; i < 10000; ++i) {
    const DVec3 slip = std::abs(any(random)) * DVec3(any(random), any(random), any(random));
    const double pressed = positive(random), weight = 0.2 * positive(random), coefficient = positive(random);
    const DVec3 force = friction_force(pressed, weight, slip, coefficient);
    EXPECT_LE(glm::dot(force, slip), 0.0);
    EXPECT_LE(glm::length(force), coefficient * pressed * (1.0 + 1e-12));
    EXPECT_LE(glm::length(force), kFrictionDamping * weight * glm::length(slip) * (1.0 + 1e-12))
        << "as damping it stays below its bound";
  }
}

TEST(Friction, IsFullWhenSlippingFastAndContinuousThroughRest) {
  EXPECT_NEAR(friction_force(2.0, 1.0, {0.3, 0.0, 0.0}, 0.4).x, -0.8, 1e-12);
  double last = friction_force(2.0, 1.0, {-0.1, 0.0, 0.0}, 0.4).x;
  for (double speed = -0.1; speed <= 0.1; speed += 1e-5) {
    const double force = friction_force(2.0, 1.0, {speed, 0.0, 0.0}, 0.4).x;
    EXPECT_LE(std::abs(force - last), 1.01e-5 * kFrictionDamping);
    last = force;
  }
  EXPECT_EQ(friction_force(2.0, 1.0, DVec3(0.0), 0.4), DVec3(0.0));
  EXPECT_EQ(friction_force(0.0, 1.0, {0.3, 0.0, 0.0}, 0.4), DVec3(0.0));
}

}  // namespace
}  // namespace palpate
