#include "engine/runtime/tool_grip.h"

#include <gtest/gtest.h>

#include "engine/device/rotation_vector.h"
#include "tests/support/random_poses.h"

namespace palpate::test {
namespace {

constexpr double kTiny = 1e-12;

DeviceState state_at(const DVec3& position, const DVec3& turn, std::uint32_t buttons = 0) {
  DeviceState state;
  state.tool.position = position;
  state.tool.orientation = rotation_by(turn);
  state.buttons = buttons;
  return state;
}

Pose random_pose(Random& random, double reach) {
  return {random.rotation(), random.uniform(0.0, reach) * random.direction()};
}

DeviceMapping random_mapping(Random& random) {
  DeviceMapping mapping;
  mapping.world_from_base = random_pose(random, 2.0);
  mapping.handle_from_tool = random_pose(random, 0.2);
  mapping.motion_scale = random.uniform(0.1, 10.0);
  mapping.force_scale = random.uniform(0.1, 10.0);
  return mapping;
}

double distance(const Pose& a, const Pose& b) {
  double most = glm::distance(a.translation, b.translation);
  for (int i = 0; i < 3; ++i) most = std::max(most, glm::distance(a.rotation[i], b.rotation[i]));
  return most;
}

TEST(ToolGrip, PutsTheToolIntoTheHandle) {
  DeviceMapping mapping;
  mapping.world_from_base = {glm::mat3_cast(rotation_by({0.0, 1.5707963267948966, 0.0})), {1.0, 2.0, 3.0}};
  mapping.handle_from_tool.translation = {0.0, 0.0, -0.1};
  mapping.motion_scale = 2.0;
  ToolGrip grip(mapping);
  // Half a metre towards the user is one to the right of a world that is turned by a quarter.
  const Pose tool = grip.follow(state_at({0.0, 0.0, 0.5}, DVec3(0.0)), Pose{});
  EXPECT_LT(glm::distance(tool.translation, DVec3(1.9, 2.0, 3.0)), kTiny);
  EXPECT_LT(glm::distance(tool.rotation * DVec3(0.0, 0.0, 1.0), DVec3(1.0, 0.0, 0.0)), kTiny);
}

// Whatever the mapping, the hand's work is the tool's in one proportion, for every small motion of the
// handle.
TEST(ToolGrip, KeepsWorkInProportion) {
  constexpr std::uint64_t kSeed = 11;
  constexpr double kSmall = 1e-6;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  Random random(kSeed);
  for (int round = 0; round < 200; ++round) {
    const DeviceMapping mapping = random_mapping(random);
    ToolGrip grip(mapping);
    const DeviceState before = state_at(random.direction(), random.direction());
    const DVec3 moved = kSmall * random.direction(), turned = kSmall * random.direction();
    DeviceState after = before;
    after.tool.position += moved;
    after.tool.orientation = rotation_by(turned) * before.tool.orientation;

    const Pose tool = grip.follow(before, Pose{});
    const DVec3 on_tool = random.direction(), force = random.direction();
    const DVec3 reference = random.direction();
    const Wrench wrench = wrench_about(reference, tool * on_tool, force);
    const DeviceWrench felt = grip.on_hand(wrench, reference);
    const double by_tool = glm::dot(force, grip.follow(after, Pose{}) * on_tool - tool * on_tool);
    const double by_hand = glm::dot(felt.force, moved) + glm::dot(felt.torque, turned);
    const double proportion = mapping.force_scale / mapping.motion_scale;
    EXPECT_NEAR(by_hand, proportion * by_tool, 1e-4 * kSmall * mapping.force_scale * 20.0) << round;
  }
}

TEST(ToolGrip, ClutchLeavesTheToolWhereItIs) {
  constexpr std::uint32_t kButton = 2;
  Random random(12);
  DeviceMapping mapping = random_mapping(random);
  mapping.clutch = kButton;
  ToolGrip grip(mapping);
  const Pose held = grip.follow(state_at({0.1, 0.0, 0.0}, {0.1, 0.2, 0.3}), Pose{});
  const Wrench wrench{{1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}};
  EXPECT_GT(glm::length(grip.on_hand(wrench, DVec3(0.0)).force), 0.0);

  // Moved and turned without it.
  const DeviceState elsewhere = state_at({-0.1, 0.05, 0.02}, {-0.4, 0.9, 0.2});
  DeviceState clutched = elsewhere;
  clutched.buttons = kButton | 1;
  EXPECT_EQ(distance(grip.follow(clutched, held), held), 0.0);
  EXPECT_EQ(grip.on_hand(wrench, DVec3(0.0)).force, DVec3(0.0)) << "what is let go pushes nobody";
  EXPECT_EQ(grip.on_hand(wrench, DVec3(0.0)).torque, DVec3(0.0));

  // Taken up without a jump, and moved on from there in the directions of the hand.
  EXPECT_LT(distance(grip.follow(elsewhere, held), held), kTiny);
  EXPECT_GT(glm::length(grip.on_hand(wrench, DVec3(0.0)).force), 0.0);
  const DVec3 step(0.0, 0.01, 0.0), turn(0.0, 0.0, 0.1);
  DeviceState after = elsewhere;
  after.tool.position += step;
  after.tool.orientation = rotation_by(turn) * elsewhere.tool.orientation;
  const Pose moved = grip.follow(after, held);
  const DMat3& base = mapping.world_from_base.rotation;
  const DMat3 turned = base * glm::mat3_cast(rotation_by(turn)) * glm::transpose(base);
  const DVec3 place = inverse(mapping.handle_from_tool).translation;  // on the tool, in the hand
  EXPECT_LT(distance({moved.rotation, DVec3(0.0)}, {turned * held.rotation, DVec3(0.0)}), kTiny);
  EXPECT_LT(glm::distance(moved * place, held * place + base * (mapping.motion_scale * step)), kTiny);
}

TEST(ToolGrip, TakesAToolUpWhereItIs) {
  Random random(13);
  DeviceMapping mapping = random_mapping(random);
  mapping.keep_tool_pose = true;
  ToolGrip grip(mapping);
  const Pose lying = random_pose(random, 1.0);
  const DeviceState state = state_at({0.02, 0.03, 0.04}, {0.3, 0.1, 0.2});
  EXPECT_LT(distance(grip.follow(state, lying), lying), kTiny);
  EXPECT_LT(distance(grip.follow(state, Pose{}), lying), kTiny) << "from then on it follows";
}

TEST(ToolGrip, DoesNotDriftWhenClutchedOften) {
  Random random(14);
  DeviceMapping mapping = random_mapping(random);
  mapping.clutch = 1;
  ToolGrip grip(mapping);
  const Pose start = grip.follow(state_at(DVec3(0.0), DVec3(0.0)), Pose{});
  Pose tool = start;
  for (int round = 0; round < 1000; ++round) {
    DeviceState state = state_at(0.1 * random.direction(), random.direction(), 1);
    tool = grip.follow(state, tool);
    state.buttons = 0;
    tool = grip.follow(state, tool);
  }
  EXPECT_LT(distance(tool, start), 1e-10);
  const DMat3 error = glm::transpose(tool.rotation) * tool.rotation - DMat3(1.0);
  for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(error[i]), 1e-10);
}

}  // namespace
}  // namespace palpate::test
