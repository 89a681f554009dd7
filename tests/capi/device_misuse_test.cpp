#include <cstring>
#include <functional>
#include <limits>
#include <string>

#include "tests/capi/devices.h"

namespace palpate::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Expects INVALID_ARGUMENT with a sentence that names `what`.
void expect_refused(plp_result result, const char* what) {
  EXPECT_EQ(result, PLP_ERROR_INVALID_ARGUMENT) << what;
  EXPECT_NE(std::string(plp_last_error()).find(what), std::string::npos) << plp_last_error();
}

class DeviceMisuse : public testing::Test {
 protected:
  plp_result set_hand(const std::function<void(plp_hand_options&)>& change) {
    plp_hand_options options = hand_options();
    change(options);
    return plp_device_set_hand(device_.handle, &options);
  }

  plp_result set_limits(const std::function<void(plp_safety_limits&)>& change) {
    plp_safety_limits limits = safety_limits();
    change(limits);
    return plp_device_set_limits(device_.handle, &limits);
  }

  plp_result set_device(const std::function<void(plp_device_mapping&)>& change) {
    plp_device_mapping mapping = device_mapping();
    change(mapping);
    return plp_scene_set_device(scene_.handle, device_.handle, &mapping);
  }

  TestDevice device_{"sim:touch"};
  TestScene scene_{0.1};
};

// Every function of a device, called with one handle and valid arguments.
void expect_handle_refused(plp_device device) {
  plp_device_info info;
  plp_device_info_init(&info, sizeof info);
  plp_device_state state;
  plp_device_state_init(&state, sizeof state);
  const plp_hand_options hand = hand_options();
  const plp_safety_limits limits = safety_limits();
  const double time = 0.0;
  const plp_pose pose = at(0, 0, 0);
  EXPECT_EQ(plp_device_retain(device), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_get_info(device, &info), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_get_state(device, &state), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_arm(device), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_disarm(device), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_calibrate(device), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_set_limits(device, &limits), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_set_hand(device, &hand), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_set_hand_poses(device, &time, &pose, 1), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_place_in_hand(device), PLP_ERROR_INVALID_HANDLE);
}

TEST_F(DeviceMisuse, HandlesThatAreNoneAreRefused) {
  expect_handle_refused(nullptr);
  expect_handle_refused(reinterpret_cast<plp_device>(scene_.handle));
  plp_device released = nullptr;
  ASSERT_EQ(plp_device_open(nullptr, &released), PLP_OK);
  ASSERT_EQ(plp_device_release(released), PLP_OK);
  expect_handle_refused(released);
  EXPECT_EQ(plp_device_release(released), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_device_release(nullptr), PLP_OK);
  EXPECT_EQ(plp_scene_set_device(nullptr, device_.handle, nullptr), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_set_device(nullptr, nullptr, nullptr), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_set_device(scene_.handle, released, nullptr), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_scene_step(reinterpret_cast<plp_scene>(device_.handle)), PLP_ERROR_INVALID_HANDLE);
}

TEST_F(DeviceMisuse, NullPointersAreRefused) {
  const double time = 0.0;
  const plp_pose pose = at(0, 0, 0);
  std::size_t count = 0;
  expect_refused(plp_device_list(nullptr, 0, nullptr), "count");
  expect_refused(plp_device_list(nullptr, 1, &count), "infos");
  expect_refused(plp_device_open(nullptr, nullptr), "device");
  expect_refused(plp_device_get_info(device_.handle, nullptr), "info");
  expect_refused(plp_device_get_state(device_.handle, nullptr), "state");
  expect_refused(plp_device_set_limits(device_.handle, nullptr), "limits");
  expect_refused(plp_device_set_hand(device_.handle, nullptr), "options");
  expect_refused(plp_device_set_hand_poses(device_.handle, nullptr, &pose, 1), "times");
  expect_refused(plp_device_set_hand_poses(device_.handle, &time, nullptr, 1), "poses");
  plp_device_info_init(nullptr, sizeof(plp_device_info));
  plp_device_state_init(nullptr, sizeof(plp_device_state));
  plp_safety_limits_init(nullptr, sizeof(plp_safety_limits));
  plp_hand_options_init(nullptr, sizeof(plp_hand_options));
  plp_device_mapping_init(nullptr, sizeof(plp_device_mapping));
}

TEST_F(DeviceMisuse, StructsOfNoVersionAreRefused) {
  for (const std::uint32_t size : {0u, 8u, 5000u}) {
    expect_refused(set_hand([&](auto& options) { options.struct_size = size; }), "struct_size");
    expect_refused(set_limits([&](auto& limits) { limits.struct_size = size; }), "struct_size");
    expect_refused(set_device([&](auto& mapping) { mapping.struct_size = size; }), "struct_size");
    plp_device_info info{};
    info.struct_size = size;
    std::size_t count = 0;
    expect_refused(plp_device_list(&info, 1, &count), "struct_size");
    expect_refused(plp_device_get_info(device_.handle, &info), "struct_size");
    plp_device_state state{};
    state.struct_size = size;
    expect_refused(plp_device_get_state(device_.handle, &state), "struct_size");
  }
}

TEST_F(DeviceMisuse, NumbersOfAHandAreChecked) {
  expect_refused(set_hand([](auto& options) { options.grip = 4; }), "grip");
  expect_refused(set_hand([](auto& options) { options.script = -1; }), "script");
  expect_refused(set_hand([](auto& options) { options.script = 6; }), "script");
  expect_refused(set_hand([](auto& options) { options.buttons = 4; }), "buttons");
  expect_refused(set_hand([](auto& options) { options.into[1] = 0.0; }), "into");
  expect_refused(set_hand([](auto& options) { options.along[0] = 0.0; }), "along");
  expect_refused(set_hand([](auto& options) { options.into[0] = 1.0, options.into[1] = 0.0; }), "parallel");
  expect_refused(set_hand([](auto& options) { options.period = 0.0; }), "period");
  expect_refused(set_hand([](auto& options) { options.origin.orientation[3] = 0.0; }), "orientation");
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e6}) {
    expect_refused(set_hand([&](auto& options) { options.depth = bad; }), "depth");
    expect_refused(set_hand([&](auto& options) { options.travel = bad; }), "travel");
    expect_refused(set_hand([&](auto& options) { options.twist = bad; }), "twist");
    expect_refused(set_hand([&](auto& options) { options.origin.position[0] = bad; }), "origin");
  }
  const std::pair<double plp_hand_options::*, const char*> impedances[] = {
      {&plp_hand_options::mass, "mass"},
      {&plp_hand_options::damping, "damping"},
      {&plp_hand_options::stiffness, "stiffness"},
      {&plp_hand_options::inertia, "inertia"},
      {&plp_hand_options::angular_damping, "angular_damping"},
      {&plp_hand_options::angular_stiffness, "angular_stiffness"}};
  for (const auto& impedance : impedances) {
    for (const double bad : {kNan, kInfinity, -1.0, 1e9}) {
      const auto set = [&](auto& options) { options.grip = PLP_GRIP_OWN, options.*impedance.first = bad; };
      expect_refused(set_hand(set), impedance.second);
    }
  }
  EXPECT_EQ(set_hand([](auto& options) { options.grip = PLP_GRIP_OWN; }), PLP_OK) << "nobody holds it";
}

// The stiffest and lightest hand that is let in can be simulated.
TEST_F(DeviceMisuse, HandsAtTheLimitStayFinite) {
  ASSERT_EQ(set_hand([](auto& options) {
              options.grip = PLP_GRIP_OWN, options.stiffness = 1e5, options.angular_stiffness = 1e3;
              options.script = PLP_HAND_TAP, options.depth = 10.0;
            }),
            PLP_OK);
  ASSERT_EQ(plp_scene_set_device(scene_.handle, device_.handle, nullptr), PLP_OK);
  ASSERT_EQ(plp_device_arm(device_.handle), PLP_OK);
  for (int i = 0; i < 3000; ++i) {
    scene_.step();
    ASSERT_TRUE(std::isfinite(device_.state().pose.position[1])) << i;
  }
  EXPECT_EQ(device_.state().limiter_ticks[PLP_LIMITER_NON_FINITE_POSE], 0u);
}

TEST_F(DeviceMisuse, RecordingsAreChecked) {
  const double times[] = {0.0, 1.0, 1.0};
  plp_pose poses[] = {at(0, 0, 0), at(0, 0.01, 0), at(0, 0.02, 0)};
  expect_refused(plp_device_set_hand_poses(device_.handle, times, poses, 0), "at least one");
  expect_refused(plp_device_set_hand_poses(device_.handle, times, poses, 3), "time");
  EXPECT_EQ(plp_device_set_hand_poses(device_.handle, times, poses, 2), PLP_OK);
  poses[1].position[2] = kNan;
  expect_refused(plp_device_set_hand_poses(device_.handle, times, poses, 2), "poses[1]");
}

TEST_F(DeviceMisuse, LimitsCanOnlyBeTightened) {
  EXPECT_EQ(set_limits([](auto&) {}), PLP_OK);
  EXPECT_EQ(set_limits([](auto& limits) { limits.max_force = 3.3, limits.ramp_time = 0.75; }), PLP_OK)
      << "the device's own";
  expect_refused(set_limits([](auto& limits) { limits.max_force = 3.4; }), "max_force");
  expect_refused(set_limits([](auto& limits) { limits.max_torque = 0.1; }), "max_torque");
  expect_refused(set_limits([](auto& limits) { limits.force_slew = 830.0; }), "force_slew");
  EXPECT_EQ(set_limits([](auto& limits) { limits.force_slew = 820.0; }), PLP_OK) << "3.3 N in 4 ms";
  expect_refused(set_limits([](auto& limits) { limits.torque_slew = 1.0; }), "torque_slew");
  expect_refused(set_limits([](auto& limits) { limits.max_speed = 6.0; }), "max_speed");
  expect_refused(set_limits([](auto& limits) { limits.max_turn_rate = 61.0; }), "max_turn_rate");
  expect_refused(set_limits([](auto& limits) { limits.watchdog = 0.1; }), "watchdog");
  expect_refused(set_limits([](auto& limits) { limits.ramp_time = 0.1; }), "ramp_time");
  expect_refused(set_limits([](auto& limits) { limits.fault_hold = 0.01; }), "fault_hold");
  expect_refused(set_limits([](auto& limits) { limits.dead_man = 4; }), "dead_man");
  for (const double bad : {kNan, -1.0, kInfinity}) {
    expect_refused(set_limits([&](auto& limits) { limits.max_force = bad; }), "max_force");
    expect_refused(set_limits([&](auto& limits) { limits.ramp_time = bad; }), "ramp_time");
  }
}

TEST_F(DeviceMisuse, MappingsAreChecked) {
  expect_refused(set_device([](auto& mapping) { mapping.flags = 2; }), "flags");
  expect_refused(set_device([](auto& mapping) { mapping.reserved = 1; }), "reserved");
  expect_refused(set_device([](auto& mapping) { mapping.scene_from_base.position[0] = kNan; }),
                 "scene_from_base");
  expect_refused(set_device([](auto& mapping) { mapping.handle_from_tool.orientation[3] = 0.0; }),
                 "handle_from_tool");
  for (const double bad : {kNan, kInfinity, -1.0, 1e10}) {
    expect_refused(set_device([&](auto& mapping) { mapping.motion_scale = bad; }), "motion_scale");
    expect_refused(set_device([&](auto& mapping) { mapping.force_scale = bad; }), "force_scale");
  }
  expect_refused(set_device([](auto& mapping) { mapping.motion_scale = 0.0; }), "motion_scale");
  for (const double bad : {kNan, kInfinity, 1e-4, 1.01})
    expect_refused(set_device([&](auto& mapping) { mapping.torque_lever[1] = bad; }), "torque_lever");
  EXPECT_EQ(set_device([](auto& mapping) { mapping.force_scale = 0.0; }), PLP_OK);
}

}  // namespace
}  // namespace palpate::test
