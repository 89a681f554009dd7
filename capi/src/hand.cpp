#include <algorithm>
#include <cmath>

#include "capi/src/handles.h"
#include "capi/src/numbers.h"
#include "capi/src/structs.h"
#include "engine/device/simulated/recorded_motion.h"
#include "engine/device/simulated/scripted_motion.h"

namespace palpate::capi {
namespace {

constexpr double kLongest = 10.0;  // m

static_assert(static_cast<int>(HandScript::kHold) == PLP_HAND_HOLD);
static_assert(static_cast<int>(HandScript::kTap) == PLP_HAND_TAP);
static_assert(static_cast<int>(HandScript::kPress) == PLP_HAND_PRESS);
static_assert(static_cast<int>(HandScript::kSlide) == PLP_HAND_SLIDE);
static_assert(static_cast<int>(HandScript::kWedge) == PLP_HAND_WEDGE);
static_assert(static_cast<int>(HandScript::kCircle) == PLP_HAND_CIRCLE);

// Written so that a NaN is refused.
double within(double low, double number, double high, const char* name) {
  if (number >= low && number <= high) return number;
  refuse(ErrorCode::kInvalidArgument,
         std::string(name) + " is not within " + std::to_string(low) + " and " + std::to_string(high));
}

HandImpedance own_impedance(const plp_hand_options& options) {
  // Beyond these a hand is none, and faster than the simulation can follow.
  return {.mass = within(0.0, options.mass, 100.0, "options->mass"),
          .damping = within(0.0, options.damping, 1e4, "options->damping"),
          .stiffness = within(0.0, options.stiffness, 1e5, "options->stiffness"),
          .inertia = within(0.0, options.inertia, 1.0, "options->inertia"),
          .angular_damping = within(0.0, options.angular_damping, 100.0, "options->angular_damping"),
          .angular_stiffness = within(0.0, options.angular_stiffness, 1e3, "options->angular_stiffness")};
}

HandImpedance impedance_in(const plp_hand_options& options) {
  switch (options.grip) {
    case PLP_GRIP_RELEASED:
      return impedance_of(Grip::kReleased);
    case PLP_GRIP_LIGHT:
      return impedance_of(Grip::kLight);
    case PLP_GRIP_FIRM:
      return impedance_of(Grip::kFirm);
    case PLP_GRIP_OWN:
      return own_impedance(options);
  }
  refuse_argument("options->grip", " is no plp_grip");
}

HandPose hand_pose(const plp_pose& pose, const char* name) {
  const Pose given = Space().pose_in(pose, name);
  for (int i = 0; i < 3; ++i) within(-kLongest, given.translation[i], kLongest, name);
  return {given.translation, glm::normalize(glm::quat_cast(given.rotation))};
}

DVec3 direction(const double numbers[3], const char* name) {
  const DVec3 given = checked(vector_of(numbers), name);
  const double largest = std::max({std::abs(given.x), std::abs(given.y), std::abs(given.z)});
  if (largest == 0.0) refuse_argument(name, " is zero");
  return glm::normalize(given / largest);
}

ScriptParameters parameters_of(const plp_hand_options& options) {
  constexpr double kParallel = 1e-6;
  ScriptParameters parameters;
  parameters.origin = hand_pose(options.origin, "options->origin");
  parameters.into = direction(options.into, "options->into");
  const DVec3 along = direction(options.along, "options->along");
  const DVec3 across = along - glm::dot(along, parameters.into) * parameters.into;
  const bool parallel = glm::length(across) < kParallel;
  if (parallel && options.travel != 0.0) refuse_argument("options->along", " is parallel to into");
  parameters.along = parallel ? DVec3(0.0) : glm::normalize(across);
  parameters.depth = within(-kLongest, options.depth, kLongest, "options->depth");
  parameters.travel = within(-kLongest, options.travel, kLongest, "options->travel");
  parameters.twist = within(-100.0, options.twist, 100.0, "options->twist");
  parameters.period = within(1e-3, options.period, 1e6, "options->period");
  return parameters;
}

std::shared_ptr<const HandMotion> motion_of(const plp_hand_options& options) {
  if (options.script < PLP_HAND_HOLD || options.script > PLP_HAND_CIRCLE) {
    refuse_argument("options->script", " is no plp_hand_script");
  }
  return std::make_shared<ScriptedMotion>(static_cast<HandScript>(options.script), parameters_of(options));
}

HandOrder order_of(const plp_hand_options& options, int buttons) {
  if (buttons < 32 && options.buttons >> buttons != 0) {
    refuse_argument("options->buttons", " names a button that the device has not");
  }
  HandOrder order;
  order.impedance = impedance_in(options);
  order.motion = motion_of(options);
  order.buttons = options.buttons;
  return order;
}

std::shared_ptr<const HandMotion> recorded(const double* times, const plp_pose* poses, std::size_t count) {
  require(times, "times is null");
  require(poses, "poses is null");
  std::vector<RecordedPose> rows;
  rows.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = "poses[" + std::to_string(i) + "]";
    rows.push_back({times[i], hand_pose(poses[i], name.c_str())});
  }
  return value_or_refuse(RecordedMotion::from(std::move(rows)));
}

void give(GuardedDevice& device, HandOrder order) {
  if (device.order_hand(std::move(order))) return;
  refuse(ErrorCode::kUnsupported, "no simulated hand holds " + device.info().identity.uri);
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_hand_options_init(plp_hand_options* options, size_t size) {
  const ScriptParameters defaults;
  plp_hand_options filled{};
  filled.grip = PLP_GRIP_LIGHT;
  filled.script = PLP_HAND_HOLD;
  filled.origin.orientation[3] = 1.0;
  store(defaults.into, filled.into);
  store(defaults.along, filled.along);
  filled.depth = defaults.depth;
  filled.travel = defaults.travel;
  filled.period = defaults.period;
  fill_struct(filled, options, size);
}

plp_result plp_device_set_hand(plp_device device, const plp_hand_options* options) {
  return guarded([&] {
    const auto object = device_table().pin(bits_of(device));
    require_handle(object, "device");
    GuardedDevice& held = *object->device;
    give(held, order_of(read_struct(options, "options"), held.info().capabilities.buttons));
  });
}

plp_result plp_device_set_hand_poses(plp_device device, const double* times, const plp_pose* poses,
                                     size_t count) {
  return guarded([&] {
    const auto object = device_table().pin(bits_of(device));
    require_handle(object, "device");
    HandOrder order;
    order.motion = recorded(times, poses, count);
    give(*object->device, std::move(order));
  });
}

plp_result plp_device_place_in_hand(plp_device device) {
  return guarded([&] {
    const auto object = device_table().pin(bits_of(device));
    require_handle(object, "device");
    HandOrder order;
    order.place = true;
    give(*object->device, std::move(order));
  });
}
