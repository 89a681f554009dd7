#include "engine/device/simulated/simulated_phantom.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/device/rotation_vector.h"
#include "engine/device/simulated/scripted_motion.h"

namespace palpate {
namespace {

constexpr double kTick = 1e-3;

std::shared_ptr<const HandMotion> circling() {
  ScriptParameters parameters;
  parameters.twist = 0.4;
  return std::make_shared<ScriptedMotion>(HandScript::kCircle, parameters);
}

// The readings of a device that renders a soft floor to a circling hand.
std::vector<DeviceState> readings(SimulatedPhantom& phantom, int ticks) {
  phantom.set_motion(circling());
  std::vector<DeviceState> states;
  for (int i = 0; i < ticks; ++i) {
    states.push_back(phantom.read());
    const double depth = std::max(0.0, -states.back().tool.position.y);
    phantom.write({DVec3(0.0, 300.0 * depth, 0.0), DVec3(0.0, 0.0, depth)});
    phantom.step(kTick);
  }
  return states;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const DVec3& a, const DVec3& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

bool same_bits(const DeviceState& a, const DeviceState& b) {
  const DQuat &p = a.tool.orientation, &q = b.tool.orientation;
  return same_bits(a.tool.position, b.tool.position) && same_bits(p.w, q.w) &&
         same_bits(DVec3(p.x, p.y, p.z), DVec3(q.x, q.y, q.z)) &&
         same_bits(a.tool.linear_velocity, b.tool.linear_velocity) &&
         same_bits(a.tool.angular_velocity, b.tool.angular_velocity) && same_bits(a.time, b.time) &&
         a.sequence == b.sequence && a.buttons == b.buttons && a.calibrated == b.calibrated;
}

void run(SimulatedPhantom& phantom, double seconds, const DeviceWrench& wrench) {
  for (int i = 0; i < std::lround(seconds / kTick); ++i) {
    phantom.write(wrench);
    phantom.step(kTick);
  }
}

TEST(SimulatedPhantom, ReadsWholeCounts) {
  for (const PhantomSpec& spec : phantom_specs()) {
    SimulatedPhantom phantom(spec);
    phantom.set_motion(circling());
    const double count = spec.limits.position_resolution;
    double largest = 0.0;
    for (int i = 0; i < 2000; ++i) {
      phantom.step(kTick);
      const RigidMotion read = phantom.read().tool;
      const RigidMotion& real = phantom.true_motion();
      for (int axis = 0; axis < 3; ++axis) {
        const double counts = read.position[axis] / count;
        ASSERT_NEAR(counts, std::round(counts), 1e-9);
        ASSERT_LE(std::abs(read.position[axis] - real.position[axis]), 0.5 * count + 1e-12);
      }
      const double turn = glm::length(rotation_between(read.orientation, real.orientation));
      ASSERT_LE(turn, 0.5 * std::sqrt(3.0) * spec.limits.angle_resolution * (1.0 + 1e-6));
      largest = std::max(largest, turn);
    }
    EXPECT_GT(largest, 0.2 * spec.limits.angle_resolution) << "angles are quantised too";
  }
}

TEST(SimulatedPhantom, ReadsVelocitiesOfASteadyMotion) {
  ScriptParameters parameters;
  parameters.twist = 0.4;
  SimulatedPhantom phantom(premium6dof_spec());
  phantom.set_motion(std::make_shared<ScriptedMotion>(HandScript::kSlide, parameters));
  for (int i = 0; i < 1125; ++i) phantom.step(kTick);
  const RigidMotion read = phantom.read().tool;
  const RigidMotion& real = phantom.true_motion();
  // A low pass of 1.6 ms lags, a count in a tick is 30 mm/s before it.
  EXPECT_NEAR(read.linear_velocity.x, real.linear_velocity.x, 0.02);
  EXPECT_GT(real.linear_velocity.x, 0.03);
  EXPECT_LT(glm::distance(read.angular_velocity, real.angular_velocity), 0.15);
  EXPECT_GT(glm::length(real.angular_velocity), 1.0);
}

TEST(SimulatedPhantom, DelaysItsSamples) {
  for (const int delay : {0, 1, 3, SampleDelay::kLongest}) {
    SimulatedPhantom prompt(premium6dof_spec());
    SimulatedPhantom late(premium6dof_spec(), delay);
    prompt.set_motion(circling());
    late.set_motion(circling());
    std::vector<DeviceState> history;
    for (int i = 0; i < 100; ++i) {
      history.push_back(prompt.read());
      EXPECT_TRUE(same_bits(late.read(), history[static_cast<std::size_t>(std::max(0, i - delay))])) << i;
      prompt.step(kTick);
      late.step(kTick);
    }
  }
}

TEST(SimulatedPhantom, SaturatesWithoutTurningAWrench) {
  SimulatedPhantom phantom(premium6dof_spec());
  const DVec3 direction = glm::normalize(DVec3(1.0, -2.0, 0.5));
  phantom.write({100.0 * direction, -7.0 * direction});
  EXPECT_LT(glm::distance(phantom.applied().force, 8.5 * direction), 1e-12);
  EXPECT_LT(glm::distance(phantom.applied().torque, -0.188 * direction), 1e-12);
  phantom.write({0.5 * direction, 0.01 * direction});
  EXPECT_EQ(phantom.applied().force, 0.5 * direction);
  EXPECT_EQ(phantom.applied().torque, 0.01 * direction);
}

TEST(SimulatedPhantom, HasNoTorqueAsATouch) {
  SimulatedPhantom phantom(touch_spec());
  phantom.write({DVec3(0.0, 10.0, 0.0), DVec3(1.0)});
  EXPECT_DOUBLE_EQ(phantom.applied().force.y, 3.3);
  EXPECT_EQ(phantom.applied().torque, DVec3(0.0));
}

TEST(SimulatedPhantom, IgnoresAWrenchThatIsNoNumber) {
  SimulatedPhantom phantom(premium6dof_spec());
  const double infinite = std::numeric_limits<double>::infinity();
  phantom.write({DVec3(std::nan(""), 1.0, 0.0), DVec3(0.0, infinite, 0.0)});
  EXPECT_EQ(phantom.applied().force, DVec3(0.0));
  EXPECT_EQ(phantom.applied().torque, DVec3(0.0));
}

TEST(SimulatedPhantom, LetsGoWhenNothingIsWritten) {
  SimulatedPhantom phantom(premium6dof_spec());
  phantom.write({DVec3(1.0, 0.0, 0.0), DVec3(0.0)});
  for (int i = 0; i < 10; ++i) phantom.step(kTick);
  EXPECT_EQ(phantom.applied().force.x, 1.0);
  phantom.step(kTick);
  phantom.step(kTick);
  EXPECT_EQ(phantom.applied().force.x, 0.0);
}

TEST(SimulatedPhantom, YieldsToAForceAsItsHandIsStiff) {
  const double force = 2.0, friction = premium6dof_spec().handle.friction;
  for (const Grip grip : {Grip::kLight, Grip::kFirm}) {
    SimulatedPhantom phantom(premium6dof_spec());
    phantom.set_grip(grip);
    run(phantom, 2.0, {DVec3(force, 0.0, 0.0), DVec3(0.0)});
    const double stiffness = impedance_of(grip).stiffness;
    EXPECT_NEAR(phantom.true_motion().position.x, force / stiffness, friction / stiffness);
  }
}

TEST(SimulatedPhantom, FliesToItsStopWhenReleased) {
  SimulatedPhantom phantom(premium6dof_spec());
  phantom.set_grip(Grip::kReleased);
  run(phantom, 2.0, {DVec3(2.0, 0.0, 0.0), DVec3(0.0)});
  EXPECT_NEAR(phantom.true_motion().position.x, 0.5 * 0.381 + 2e-4, 2e-5);
}

TEST(SimulatedPhantom, TakesNoTimeThatIsNoneAndLittleOfAPause) {
  SimulatedPhantom phantom(premium6dof_spec());
  const DeviceState before = phantom.read();
  for (const double dt : {0.0, -1.0, std::nan("")}) phantom.step(dt);
  EXPECT_TRUE(same_bits(phantom.read(), before));
  phantom.step(3600.0);
  EXPECT_NEAR(phantom.read().time - before.time, 0.1, 1e-12);
  EXPECT_EQ(phantom.read().sequence, before.sequence + 1);
}

TEST(SimulatedPhantom, ReadsButtonsWithTheNextSample) {
  SimulatedPhantom phantom(touch_spec());
  phantom.set_buttons(0b10);
  EXPECT_EQ(phantom.read().buttons, 0u);
  phantom.step(kTick);
  EXPECT_EQ(phantom.read().buttons, 0b10u);
}

TEST(SimulatedPhantom, IsPlacedWhereTheHandIs) {
  ScriptParameters parameters;
  parameters.origin.position = {0.03, -0.06, 0.09};
  parameters.origin.orientation = rotation_by(DVec3(0.5, 0.0, 0.0));
  SimulatedPhantom phantom(premium6dof_spec(), 2);
  const std::uint64_t before = phantom.read().sequence;
  phantom.set_motion(std::make_shared<ScriptedMotion>(HandScript::kHold, parameters));
  phantom.place_in_hand();
  const DeviceState state = phantom.read();
  EXPECT_LT(glm::distance(state.tool.position, parameters.origin.position), 30e-6);
  EXPECT_LT(glm::length(rotation_between(state.tool.orientation, parameters.origin.orientation)), 1e-4);
  EXPECT_EQ(state.tool.linear_velocity, DVec3(0.0));
  EXPECT_GT(state.sequence, before);
  EXPECT_TRUE(state.calibrated);
}

TEST(SimulatedPhantom, RepeatsItselfBitByBit) {
  for (const PhantomSpec& spec : phantom_specs()) {
    SimulatedPhantom first(spec, 1), second(spec, 1);
    const auto a = readings(first, 1500), b = readings(second, 1500);
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_TRUE(same_bits(a[i], b[i])) << i;
    EXPECT_TRUE(same_bits(first.energy().by_actuators, second.energy().by_actuators));
    EXPECT_NE(first.energy().by_actuators, 0.0);
  }
}

}  // namespace
}  // namespace palpate
