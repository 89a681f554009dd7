#include "engine/device/simulated/phantom_spec.h"

#include <array>
#include <string>

namespace palpate {
namespace {

constexpr double kDegree = 0.017453292519943295;  // rad

// Maximum force, torque, stiffness and damping are those that haptic libraries use for these devices.
// Workspace, continuous force, position resolution, friction and tip inertia are nominal, as their maker
// published them. Rotational inertia, its friction, all viscous damping and the angle resolution are nominal
// too: of the size that a handle of these dimensions has, measured on no device.

Box centred_box(const DVec3& size) {
  return {-0.5 * size, 0.5 * size};
}

PhantomSpec premium6dof() {
  PhantomSpec spec;
  spec.uri_name = "premium6dof";
  spec.name = "Simulated PHANToM Premium 1.5/6DOF";
  spec.capabilities = {kAllDegrees, kAllDegrees, 1};
  spec.limits.max_force = 8.5;
  spec.limits.continuous_force = 1.4;
  spec.limits.max_torque = 0.188;
  spec.limits.continuous_torque = 0.188;
  spec.limits.max_stiffness = 800.0;
  spec.limits.max_damping = 5.0;
  spec.limits.position_resolution = 30e-6;
  spec.limits.angle_resolution = 0.0023 * kDegree;
  spec.limits.update_rate = 1000.0;
  spec.limits.workspace = centred_box({0.381, 0.267, 0.191});
  spec.handle = {.mass = 0.075,
                 .damping = 0.01,
                 .friction = 0.04,
                 .inertia = 1e-4,
                 .angular_damping = 1e-4,
                 .angular_friction = 1e-3};
  return spec;
}

PhantomSpec touch() {
  PhantomSpec spec;
  spec.uri_name = "touch";
  spec.name = "Simulated PHANToM Touch";
  spec.capabilities = {kAllDegrees, kTranslations, 2};
  spec.limits.max_force = 3.3;
  spec.limits.continuous_force = 0.88;
  spec.limits.max_stiffness = 400.0;
  spec.limits.max_damping = 4.0;
  spec.limits.position_resolution = 55e-6;
  spec.limits.angle_resolution = 0.3 * kDegree;
  spec.limits.update_rate = 1000.0;
  spec.limits.workspace = centred_box({0.160, 0.120, 0.070});
  spec.handle = {.mass = 0.045,
                 .damping = 0.01,
                 .friction = 0.26,
                 .inertia = 2e-5,
                 .angular_damping = 5e-5,
                 .angular_friction = 5e-4};
  return spec;
}

const std::array<PhantomSpec, 2>& all() {
  static const std::array<PhantomSpec, 2> specs = {premium6dof(), touch()};
  return specs;
}

}  // namespace

const PhantomSpec& premium6dof_spec() {
  return all()[0];
}

const PhantomSpec& touch_spec() {
  return all()[1];
}

DeviceInfo info_of(const PhantomSpec& spec) {
  return {{"sim:" + std::string(spec.uri_name), std::string(spec.name), ""}, spec.capabilities, spec.limits};
}

std::span<const PhantomSpec> phantom_specs() {
  return all();
}

}  // namespace palpate
