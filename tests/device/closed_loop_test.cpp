#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "engine/device/safety_limits.h"
#include "engine/device/simulated/scripted_motion.h"
#include "engine/device/simulated/simulated_phantom.h"

namespace palpate {
namespace {

constexpr double kTick = 1e-3;        // s
constexpr int kTicksPerCycle = 1000;  // the scripts' period
constexpr double kReach = 0.010;      // m below the origin of the walls that the hand wants to be
constexpr double kHeight = 0.005;     // m above it where the hand starts
constexpr double kSway = 0.02;        // m along the floor, or to both sides in the wedge

// A plane through the origin; what is behind it is pushed out along its normal.
struct Wall {
  DVec3 normal;
};

const std::vector<Wall> kFloor = {{{0.0, 1.0, 0.0}}};
// Two walls that meet at the origin, 30° to both sides of the upright.
const std::vector<Wall> kWedge = {{{0.5 * std::sqrt(3.0), 0.5, 0.0}}, {{-0.5 * std::sqrt(3.0), 0.5, 0.0}}};

// A device in a light hand, walls of one stiffness, and the safety limits between.
class ClosedLoop {
 public:
  ClosedLoop(const PhantomSpec& spec, const std::vector<Wall>& walls, double stiffness)
      : phantom_(spec),
        limits_(SafetySettings::for_device(spec.limits)),
        walls_(walls),
        stiffness_(stiffness) {
    follow(HandScript::kHold);
    phantom_.place_in_hand();
    limits_.arm();
    for (int i = 0; i < 2 * kTicksPerCycle; ++i) tick();
  }

  void follow(HandScript script) {
    ScriptParameters parameters;
    parameters.origin.position = {0.0, kHeight, 0.0};
    parameters.depth = kHeight + kReach;
    parameters.travel = kSway;
    phantom_.set_motion(std::make_shared<ScriptedMotion>(script, parameters));
  }

  void tick() {
    const DeviceState state = phantom_.read();
    phantom_.write(limits_.apply({{push_at(state.tool.position), DVec3(0.0)}, ++computed_}, state, kTick));
    phantom_.step(kTick);
  }

  // How deep the handle is in the wall it is deepest in, m.
  double depth() const {
    double deepest = 0.0;
    for (const Wall& wall : walls_) deepest = std::max(deepest, -glm::dot(wall.normal, position()));
    return deepest;
  }

  const DVec3& position() const { return phantom_.true_motion().position; }
  double speed() const { return glm::length(phantom_.true_motion().linear_velocity); }
  double given_to_hand() const { return -phantom_.energy().by_hand; }  // J
  const DVec3& force() const { return phantom_.applied().force; }
  const SafetyReport& report() const { return limits_.report(); }

 private:
  DVec3 push_at(const DVec3& tool) const {
    DVec3 push(0.0);
    for (const Wall& wall : walls_) {
      push += stiffness_ * std::max(0.0, -glm::dot(wall.normal, tool)) * wall.normal;
    }
    return push;
  }

  SimulatedPhantom phantom_;
  SafetyLimits limits_;
  std::vector<Wall> walls_;
  double stiffness_;
  std::uint64_t computed_ = 0;
};

struct LoopCase {
  const PhantomSpec& (*spec)();
  HandScript script;
  const std::vector<Wall>& walls;
  const char* name;
};

// A minute at the largest stiffness that the device is rated for.
class ClosedLoopTest : public testing::TestWithParam<LoopCase> {
 protected:
  static constexpr int kCycles = 60;
  static constexpr int kTransient = 3;  // cycles until the motion has become periodic

  void SetUp() override {
    loop_.follow(GetParam().script);
    for (int cycle = 0; cycle < kCycles; ++cycle) run_cycle(cycle);
    std::printf("%-14s deepest %.2f mm, energy to the hand in a cycle at most %+.3f mJ, repeats to %.1f um\n",
                GetParam().name, 1e3 * deepest_, 1e3 * most_given_, 1e6 * least_repeated_);
  }

  void run_cycle(int cycle) {
    const double given = loop_.given_to_hand();
    for (DVec3& before : last_cycle_) {
      loop_.tick();
      deepest_ = std::max(deepest_, loop_.depth());
      if (cycle > kTransient) {
        least_repeated_ = std::max(least_repeated_, glm::distance(before, loop_.position()));
      }
      before = loop_.position();
    }
    if (cycle > kTransient) most_given_ = std::max(most_given_, loop_.given_to_hand() - given);
  }

  const DeviceLimits& limits() const { return GetParam().spec().limits; }

  ClosedLoop loop_{GetParam().spec(), GetParam().walls, GetParam().spec().limits.max_stiffness};
  std::vector<DVec3> last_cycle_ = std::vector<DVec3>(kTicksPerCycle);
  double deepest_ = 0.0;                                     // m
  double most_given_ = -std::numeric_limits<double>::max();  // J in one cycle
  double least_repeated_ = 0.0;                              // m between the same moments of two cycles
};

TEST_P(ClosedLoopTest, IsSteadyAndPassiveAndLetsNothingThrough) {
  // The hand's spring, were the handle held where walls of infinite stiffness would hold it.
  const double sideways = GetParam().script == HandScript::kWedge ? kSway : 0.0;
  const double hand_force = impedance_of(Grip::kLight).stiffness * std::hypot(kReach, sideways);
  const double allowed = std::min(hand_force, limits().max_force) / limits().max_stiffness;
  EXPECT_GT(deepest_, 0.5 * allowed) << "the hand touches";
  EXPECT_LT(deepest_, allowed);
  EXPECT_LE(most_given_, 1e-9) << "the hand got energy from a closed cycle";
  EXPECT_LT(least_repeated_, 2.0 * limits().position_resolution) << "a limit cycle does not keep step";
  EXPECT_EQ(loop_.report().state, SafetyState::kArmed);
}

INSTANTIATE_TEST_SUITE_P(
    Hands, ClosedLoopTest,
    testing::Values(LoopCase{premium6dof_spec, HandScript::kTap, kFloor, "PremiumTap"},
                    LoopCase{premium6dof_spec, HandScript::kPress, kFloor, "PremiumPress"},
                    LoopCase{premium6dof_spec, HandScript::kSlide, kFloor, "PremiumSlide"},
                    LoopCase{premium6dof_spec, HandScript::kWedge, kWedge, "PremiumWedge"},
                    LoopCase{touch_spec, HandScript::kTap, kFloor, "TouchTap"},
                    LoopCase{touch_spec, HandScript::kPress, kFloor, "TouchPress"},
                    LoopCase{touch_spec, HandScript::kSlide, kFloor, "TouchSlide"},
                    LoopCase{touch_spec, HandScript::kWedge, kWedge, "TouchWedge"}),
    [](const auto& info) { return std::string(info.param.name); });

// The limits cannot make such a wall steady, but what the hand meets stays what this device can do.
TEST(ClosedLoop, OfAbsurdStiffnessStaysWithinTheDevice) {
  ClosedLoop loop(premium6dof_spec(), kFloor, 1e9);
  loop.follow(HandScript::kPress);
  DVec3 before(0.0);
  for (int i = 0; i < 5000; ++i) {
    loop.tick();
    ASSERT_LE(glm::length(loop.force()), 8.5 * (1.0 + 1e-12)) << i;
    ASSERT_LE(glm::distance(loop.force(), before), 8.5 / 4.0 * (1.0 + 1e-9)) << i;
    ASSERT_LT(loop.speed(), 2.0) << i;
    before = loop.force();
  }
  EXPECT_GT(loop.report().ticks_of(Limiter::kForceClamp), 0u);
  EXPECT_GT(loop.report().ticks_of(Limiter::kForceSlew), 0u);
  EXPECT_EQ(loop.report().ticks_of(Limiter::kPoseJump), 0u);
}

}  // namespace
}  // namespace palpate
