#include <cstring>
#include <string>
#include <vector>

#include "tests/capi/devices.h"

namespace palpate::test {
namespace {

// A cube in a light hand above a floor, touching it with the force of a few newtons.
class DeviceScene : public testing::Test {
 protected:
  explicit DeviceScene(const char* uri = nullptr) : device_(uri) {
    scene_.add(cube_.handle, PLP_BODY_STATIC, at(0.0, -0.105, 0.0));
    tool_ = scene_.add(cube_.handle, PLP_BODY_TOOL, at(0.0, 0.0, 0.0));
    plp_scene_set_stiffness(scene_.handle, 200.0);
    plp_scene_set_stiffness_cap(scene_.handle, -1.0);
  }

  void attach(const plp_device_mapping& mapping = device_mapping()) {
    ASSERT_EQ(plp_scene_set_device(scene_.handle, device_.handle, &mapping), PLP_OK) << plp_last_error();
  }

  void step(int count) {
    for (int i = 0; i < count; ++i) ASSERT_EQ(plp_scene_step(scene_.handle), PLP_OK) << plp_last_error();
  }

  void arm() {
    ASSERT_EQ(plp_device_arm(device_.handle), PLP_OK);
    step(1500);
    ASSERT_EQ(device_.state().safety, PLP_SAFETY_ARMED);
  }

  plp_pose tool_pose() {
    plp_pose pose;
    EXPECT_EQ(plp_scene_get_pose(scene_.handle, tool_, &pose), PLP_OK);
    return pose;
  }

  TestModel cube_{box(0.05f, 0.05f, 0.05f)};
  TestDevice device_;
  TestScene scene_{0.01};
  plp_body tool_ = 0;
};

TEST(Devices, AreListed) {
  std::size_t count = 0;
  ASSERT_EQ(plp_device_list(nullptr, 0, &count), PLP_OK);
  ASSERT_GE(count, 2u);
  const std::size_t all = count;  // the simulated ones, and hardware or what it is missing
  std::vector<plp_device_info> infos(all + 1);
  std::memset(infos.data(), 0x5a, infos.size() * sizeof infos[0]);
  plp_device_info_init(&infos[0], sizeof infos[0]);
  ASSERT_EQ(plp_device_list(infos.data(), infos.size(), &count), PLP_OK) << plp_last_error();
  ASSERT_EQ(count, all);
  EXPECT_STREQ(infos[0].uri, "sim:premium6dof");
  EXPECT_STREQ(infos[1].uri, "sim:touch");
  EXPECT_EQ(infos[1].struct_size, sizeof infos[1]);
  EXPECT_EQ(infos[1].sensed, 63u);
  EXPECT_EQ(infos[1].actuated, 7u);
  EXPECT_EQ(infos[1].condition, PLP_CONDITION_READY);
  EXPECT_EQ(infos[all].struct_size, 0x5a5a5a5au) << "written beyond what there is";
  ASSERT_EQ(plp_device_list(infos.data(), 1, &count), PLP_OK);
  EXPECT_EQ(count, all);
}

TEST(Devices, AreOpenedByUri) {
  const TestDevice premium, unnamed(""), touch("sim:touch?delay=2");
  EXPECT_STREQ(unnamed.info().uri, "sim:premium6dof");
  EXPECT_STREQ(premium.info().uri, "sim:premium6dof");
  EXPECT_EQ(premium.info().max_force, 8.5);
  EXPECT_EQ(premium.info().max_stiffness, 800.0);
  EXPECT_EQ(premium.info().workspace_max[0], 0.1905);
  EXPECT_STREQ(touch.info().uri, "sim:touch?delay=2");
  EXPECT_EQ(touch.info().max_torque, 0.0);
  EXPECT_EQ(touch.info().condition, PLP_CONDITION_READY);
  EXPECT_STREQ(touch.info().status, "ready");
  EXPECT_EQ(plp_device_calibrate(touch.handle), PLP_ERROR_UNSUPPORTED);
  EXPECT_EQ(touch.info().buttons, 2u);
}

TEST(Devices, ThatDoNotExistAreNamed) {
  for (const char* uri : {"usb:spoon", "sim:spoon", "sim", ":"}) {
    plp_device device = nullptr;
    EXPECT_EQ(plp_device_open(uri, &device), PLP_ERROR_DEVICE) << uri;
    EXPECT_EQ(device, nullptr);
  }
  plp_device device = nullptr;
  EXPECT_EQ(plp_device_open("usb:spoon", &device), PLP_ERROR_DEVICE);
  const std::string sentence = plp_last_error();
  for (const char* part : {"usb:spoon", "sim:premium6dof", "sim:touch"}) {
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  }
  EXPECT_EQ(plp_device_open("sim:touch?delay=9", &device), PLP_ERROR_INVALID_ARGUMENT);
}

TEST(Devices, AreCounted) {
  plp_device device = nullptr;
  ASSERT_EQ(plp_device_open(nullptr, &device), PLP_OK);
  EXPECT_EQ(plp_device_retain(device), PLP_OK);
  EXPECT_EQ(plp_device_release(device), PLP_OK);
  EXPECT_EQ(plp_device_arm(device), PLP_OK);
  EXPECT_EQ(plp_device_release(device), PLP_OK);
  EXPECT_EQ(plp_device_release(device), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_retain(device), PLP_ERROR_INVALID_HANDLE);
}

TEST_F(DeviceScene, TheHandFeelsTheFloor) {
  attach();
  arm();
  const plp_device_state state = device_.state();
  EXPECT_GT(state.applied.force[1], 0.5);
  EXPECT_EQ(state.applied.force[1], state.commanded.force[1]);
  EXPECT_EQ(state.gain, 1.0);
  EXPECT_EQ(state.ticks, 1500u);
  EXPECT_EQ(state.limiters, 0u);
  EXPECT_GT(state.limiter_ticks[PLP_LIMITER_RAMP], 500u);
  EXPECT_EQ(state.calibrated, 1);
  EXPECT_NEAR(state.time, 1.499, 1e-9);
  EXPECT_EQ(tool_pose().position[1], state.pose.position[1]);
  EXPECT_GT(tool_pose().position[1], 1e-3) << "the floor lifts the hand";
}

// Without a word of the caller: a floor by itself is at most half as stiff as the device can render.
TEST_F(DeviceScene, SpringsAreCappedByWhatTheDeviceCanRender) {
  constexpr double kStiffness = 1000.0, kRated = 800.0;  // N/m
  ASSERT_EQ(plp_scene_set_law(scene_.handle, PLP_LAW_SPRINGS), PLP_OK);
  ASSERT_EQ(plp_scene_set_stiffness(scene_.handle, kStiffness), PLP_OK);
  ASSERT_EQ(plp_scene_set_stiffness_cap(scene_.handle, 0.0), PLP_OK);
  const auto felt = [&] {
    step(1);
    return device_.state().commanded.force[1] / (0.005 - tool_pose().position[1]);
  };
  attach();
  EXPECT_NEAR(felt(), kStiffness / (1.0 + 2.0 * kStiffness / kRated), 1e-3);
  plp_device_mapping larger = device_mapping();
  larger.motion_scale = 2.0;
  larger.force_scale = 3.0;
  attach(larger);
  EXPECT_NEAR(felt(), 3.0 * kStiffness / (1.0 + 2.0 * kStiffness / (kRated / 6.0)), 1e-3);
  attach();
  ASSERT_EQ(plp_scene_set_stiffness_cap(scene_.handle, 400.0), PLP_OK);
  EXPECT_NEAR(felt(), kStiffness / (1.0 + 2.0 * kStiffness / 400.0), 1e-3);
  ASSERT_EQ(plp_scene_set_stiffness_cap(scene_.handle, -1.0), PLP_OK);
  EXPECT_NEAR(felt(), kStiffness, 1e-3);
}

TEST_F(DeviceScene, WithoutAnArmedDeviceThereIsNoForce) {
  attach();
  step(500);
  EXPECT_EQ(device_.state().safety, PLP_SAFETY_DISARMED);
  EXPECT_EQ(device_.state().applied.force[1], 0.0);
  EXPECT_GT(device_.state().commanded.force[1], 0.5);
  arm();
  ASSERT_EQ(plp_device_disarm(device_.handle), PLP_OK);
  step(1);
  EXPECT_EQ(device_.state().applied.force[1], 0.0);
}

TEST_F(DeviceScene, ADeviceIsKeptByItsSceneUntilItIsDetached) {
  attach();
  arm();
  ASSERT_EQ(plp_device_retain(device_.handle), PLP_OK);
  ASSERT_EQ(plp_device_release(device_.handle), PLP_OK);
  ASSERT_EQ(plp_scene_set_device(scene_.handle, nullptr, nullptr), PLP_OK);
  EXPECT_EQ(device_.state().applied.force[1], 0.0);
  const std::uint64_t ticks = device_.state().ticks;
  step(10);
  EXPECT_EQ(device_.state().ticks, ticks);
  EXPECT_EQ(plp_scene_set_device(scene_.handle, nullptr, nullptr), PLP_OK) << "there is none to detach";
}

TEST_F(DeviceScene, AnotherSceneMayNotHaveIt) {
  attach();
  {
    TestScene other(0.01);
    EXPECT_EQ(plp_scene_set_device(other.handle, device_.handle, nullptr), PLP_ERROR_WRONG_STATE);
    plp_scene_set_device(scene_.handle, nullptr, nullptr);
    EXPECT_EQ(plp_scene_set_device(other.handle, device_.handle, nullptr), PLP_OK);
    EXPECT_EQ(plp_scene_set_device(scene_.handle, device_.handle, nullptr), PLP_ERROR_WRONG_STATE);
  }
  EXPECT_EQ(plp_scene_set_device(scene_.handle, device_.handle, nullptr), PLP_OK) << "its scene is gone";
}

TEST_F(DeviceScene, ARunningSceneGivesItBackAtOnce) {
  TestScene other(0.01);
  ASSERT_EQ(plp_scene_start(scene_.handle, nullptr), PLP_OK);
  ASSERT_EQ(plp_scene_start(other.handle, nullptr), PLP_OK);
  for (int round = 0; round < 50; ++round) {
    ASSERT_EQ(plp_scene_set_device(scene_.handle, device_.handle, nullptr), PLP_OK) << round;
    ASSERT_EQ(plp_scene_set_device(scene_.handle, nullptr, nullptr), PLP_OK) << round;
    ASSERT_EQ(plp_scene_set_device(other.handle, device_.handle, nullptr), PLP_OK) << round;
    ASSERT_EQ(plp_scene_set_device(other.handle, nullptr, nullptr), PLP_OK) << round;
  }
  plp_scene_stop(other.handle);
  plp_scene_stop(scene_.handle);
}

TEST_F(DeviceScene, TheToolStaysWhereTheHandLeftIt) {
  const plp_pose before = tool_pose();
  attach();
  arm();
  const plp_pose held = tool_pose();
  ASSERT_NE(held.position[1], before.position[1]);
  ASSERT_EQ(plp_scene_set_device(scene_.handle, nullptr, nullptr), PLP_OK);
  EXPECT_EQ(tool_pose().position[1], held.position[1]);
  ASSERT_EQ(plp_scene_start(scene_.handle, nullptr), PLP_OK);
  EXPECT_EQ(tool_pose().position[1], held.position[1]);
  attach();
  ASSERT_EQ(plp_scene_set_device(scene_.handle, nullptr, nullptr), PLP_OK);
  const plp_pose left = tool_pose();
  plp_scene_stop(scene_.handle);
  EXPECT_EQ(tool_pose().position[1], left.position[1]);
  const plp_pose placed = at(0.0, 0.5, 0.0);
  ASSERT_EQ(plp_scene_set_pose(scene_.handle, tool_, &placed), PLP_OK);
  EXPECT_EQ(tool_pose().position[1], 0.5);
}

TEST_F(DeviceScene, TheHandDoesWhatItIsTold) {
  plp_hand_options hand = hand_options();
  hand.grip = PLP_GRIP_FIRM;
  hand.script = PLP_HAND_CIRCLE;
  hand.into[0] = 1.0, hand.into[1] = 0.0;
  hand.along[0] = 0.0, hand.along[2] = -3.0;
  hand.origin.position[1] = 0.05;
  hand.travel = 0.02;
  hand.buttons = 1;
  ASSERT_EQ(plp_device_set_hand(device_.handle, &hand), PLP_OK) << plp_last_error();
  ASSERT_EQ(plp_device_place_in_hand(device_.handle), PLP_OK);
  attach();
  step(1000);  // a whole turn, at the end of the first period
  const plp_device_state state = device_.state();
  EXPECT_NEAR(state.pose.position[0], 0.0, 4e-3);
  EXPECT_NEAR(state.pose.position[1], 0.05, 1e-3);
  EXPECT_NEAR(state.pose.position[2], -0.02, 2e-3);
  EXPECT_EQ(state.buttons, 1u);
}

TEST_F(DeviceScene, TheHandFollowsARecording) {
  const double times[] = {7.0, 7.2, 7.5};
  const plp_pose poses[] = {at(0.0, 0.05, 0.0), at(0.03, 0.05, 0.0), at(0.03, 0.06, 0.0)};
  ASSERT_EQ(plp_device_set_hand_poses(device_.handle, times, poses, 3), PLP_OK) << plp_last_error();
  ASSERT_EQ(plp_device_place_in_hand(device_.handle), PLP_OK);
  attach();
  step(1);
  EXPECT_NEAR(tool_pose().position[1], 0.05, 1e-4);
  step(1000);
  EXPECT_NEAR(tool_pose().position[0], 0.03, 1e-3);
  EXPECT_NEAR(tool_pose().position[1], 0.06, 1e-3);
}

TEST_F(DeviceScene, AHandThatIsMovedAtOnceIsAFault) {
  attach();
  arm();
  plp_hand_options hand = hand_options();
  hand.origin.position[1] = 0.03;
  ASSERT_EQ(plp_device_set_hand(device_.handle, &hand), PLP_OK);
  ASSERT_EQ(plp_device_place_in_hand(device_.handle), PLP_OK);
  step(1);
  EXPECT_EQ(device_.state().safety, PLP_SAFETY_FAULT);
  EXPECT_EQ(device_.state().limiters & 1u << PLP_LIMITER_POSE_JUMP, 1u << PLP_LIMITER_POSE_JUMP);
  EXPECT_EQ(device_.state().applied.force[1], 0.0);
  step(1500);
  EXPECT_EQ(device_.state().safety, PLP_SAFETY_ARMED);
}

TEST_F(DeviceScene, AbsurdStiffnessStaysWithinTheDevice) {
  ASSERT_EQ(plp_scene_set_stiffness(scene_.handle, 1e15), PLP_OK);
  attach();
  arm();
  double most = 0.0;
  for (int i = 0; i < 1000; ++i) {
    step(1);
    const plp_wrench applied = device_.state().applied;
    most = std::max(most, std::hypot(applied.force[0], applied.force[1], applied.force[2]));
  }
  EXPECT_LE(most, 8.5 * (1.0 + 1e-12));
  EXPECT_GT(device_.state().limiter_ticks[PLP_LIMITER_FORCE_CLAMP], 0u);
}

TEST_F(DeviceScene, LimitsAreTightened) {
  plp_safety_limits limits = safety_limits();
  limits.max_force = 0.25;
  limits.dead_man = 1;
  ASSERT_EQ(plp_device_set_limits(device_.handle, &limits), PLP_OK) << plp_last_error();
  attach();
  ASSERT_EQ(plp_device_arm(device_.handle), PLP_OK);
  step(1500);
  EXPECT_EQ(device_.state().safety, PLP_SAFETY_DISARMED) << "the dead-man button is not held";
  plp_hand_options hand = hand_options();
  hand.buttons = 1;
  ASSERT_EQ(plp_device_set_hand(device_.handle, &hand), PLP_OK);
  step(1500);
  EXPECT_EQ(device_.state().safety, PLP_SAFETY_ARMED);
  EXPECT_NEAR(device_.state().applied.force[1], 0.25, 1e-12);
  limits = safety_limits();
  ASSERT_EQ(plp_device_set_limits(device_.handle, &limits), PLP_OK);
  step(100);
  EXPECT_GT(device_.state().applied.force[1], 0.3) << "from the device's own, not from those before";
}

TEST_F(DeviceScene, MappingMovesTurnsAndScales) {
  plp_device_mapping mapping = device_mapping();
  mapping.scene_from_base = {{1.0, 2.0, 3.0}, {0.0, std::sqrt(0.5), 0.0, std::sqrt(0.5)}};
  mapping.handle_from_tool.position[1] = 0.5;
  mapping.motion_scale = 10.0;
  plp_hand_options hand = hand_options();
  hand.origin.position[2] = 0.05;
  ASSERT_EQ(plp_device_set_hand(device_.handle, &hand), PLP_OK);
  ASSERT_EQ(plp_device_place_in_hand(device_.handle), PLP_OK);
  attach(mapping);
  step(1);
  const plp_pose pose = tool_pose();
  EXPECT_NEAR(pose.position[0], 1.5, 2e-4);
  EXPECT_NEAR(pose.position[1], 2.5, 1e-9);
  EXPECT_NEAR(pose.position[2], 3.0, 1e-9);
  EXPECT_NEAR(pose.orientation[1], std::sqrt(0.5), 1e-9);
}

TEST_F(DeviceScene, AToolCanBeTakenUpWhereItIs) {
  const plp_pose lying = {{0.5, 0.6, 0.7}, {0.5, 0.5, 0.5, 0.5}};
  ASSERT_EQ(plp_scene_set_pose(scene_.handle, tool_, &lying), PLP_OK);
  plp_device_mapping mapping = device_mapping();
  mapping.flags = PLP_DEVICE_KEEP_TOOL_POSE;
  attach(mapping);
  step(10);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(tool_pose().position[i], lying.position[i], 1e-9);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(tool_pose().orientation[i], 0.5, 1e-9);
}

class TouchScene : public DeviceScene {
 protected:
  TouchScene() : DeviceScene("sim:touch") {}

  // The tool's middle is 30 mm to the right of the handle, so the force of the floor, which is as wide as the
  // tool, has a torque.
  plp_device_state pushed(double lever) {
    plp_device_mapping mapping = device_mapping();
    mapping.handle_from_tool.position[0] = 0.03;
    mapping.torque_lever[1] = lever;
    attach(mapping);
    arm();
    return device_.state();
  }

  // From the handle to the middle of what of both cubes lies over each other.
  static double lever_arm(const plp_device_state& state) { return 0.015 - 0.5 * state.pose.position[0]; }
};

TEST_F(TouchScene, TorqueIsDroppedAndTold) {
  const plp_device_state state = pushed(0.0);
  EXPECT_GT(state.commanded.force[1], 0.3);
  EXPECT_NEAR(state.commanded.torque[2], lever_arm(state) * state.commanded.force[1], 1e-6);
  EXPECT_EQ(state.unactuated, 1);
  EXPECT_EQ(state.applied.torque[2], 0.0);
  EXPECT_NEAR(state.applied.force[0], 0.0, 1e-6);
}

TEST_F(TouchScene, TorqueIsFeltAtALever) {
  const plp_device_state state = pushed(0.1);
  EXPECT_GT(state.applied.force[1], 0.3);
  EXPECT_NEAR(state.applied.force[0], -lever_arm(state) / 0.1 * state.applied.force[1], 1e-6);
  EXPECT_LT(state.applied.force[0], -0.05);
  EXPECT_NEAR(state.commanded.torque[2], 0.0, 1e-12);
}

// In a scene with +z up and millimetres the same device feels the same floor.
TEST(DeviceSpaces, TheSceneConvertsAtItsBorder) {
  const TestModel cube(box(0.05f, 0.05f, 0.05f));
  plp_scene_options options = TestScene::options_with(10.0);
  options.space = {{1, -3, 2}, 0, 0.001};
  options.stiffness = 200.0;
  options.stiffness_cap = -1.0;
  TestScene scene(options);
  scene.add(cube.handle, PLP_BODY_STATIC, at(0.0, 0.0, -105.0));
  const plp_body tool = scene.add(cube.handle, PLP_BODY_TOOL, at(0.0, 0.0, 0.0));
  const TestDevice device;
  ASSERT_EQ(plp_scene_set_device(scene.handle, device.handle, nullptr), PLP_OK);
  ASSERT_EQ(plp_device_arm(device.handle), PLP_OK);
  for (int i = 0; i < 1500; ++i) scene.step();
  plp_pose pose;
  ASSERT_EQ(plp_scene_get_pose(scene.handle, tool, &pose), PLP_OK);
  EXPECT_GT(device.state().applied.force[1], 0.5) << "up is +y for a device";
  EXPECT_NEAR(pose.position[2], 1000.0 * device.state().pose.position[1], 1e-9);
  const plp_contacts contacts = scene.step();
  EXPECT_NEAR(contacts.wrench.force[2], device.state().applied.force[1], 1e-6);
}

TEST_F(DeviceScene, TheSameStepsGiveTheSameBits) {
  attach();
  arm();
  const plp_device_state first = device_.state();
  const TestDevice again;
  TestScene scene(0.01);
  plp_scene_set_stiffness(scene.handle, 200.0);
  plp_scene_set_stiffness_cap(scene.handle, -1.0);
  scene.add(cube_.handle, PLP_BODY_STATIC, at(0.0, -0.105, 0.0));
  scene.add(cube_.handle, PLP_BODY_TOOL, at(0.0, 0.0, 0.0));
  ASSERT_EQ(plp_scene_set_device(scene.handle, again.handle, nullptr), PLP_OK);
  ASSERT_EQ(plp_device_arm(again.handle), PLP_OK);
  for (int i = 0; i < 1500; ++i) scene.step();
  const plp_device_state second = again.state();
  EXPECT_EQ(std::memcmp(&first, &second, sizeof first), 0);
}

}  // namespace
}  // namespace palpate::test
