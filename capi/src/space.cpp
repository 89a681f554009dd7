#include "capi/src/space.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "capi/src/numbers.h"

namespace palpate::capi {
namespace {

constexpr double kSmallestUnit = 1e-9;
constexpr double kLargestUnit = 1e9;

void require_axes(const plp_space& space, const char* name) {
  bool used[4] = {};
  for (const std::int32_t axis : space.axes) {
    if (axis < -3 || axis > 3 || axis == 0 || used[std::abs(axis)]) {
      refuse_argument(name, ".axes are not ±1, ±2 and ±3, each axis once");
    }
    used[std::abs(axis)] = true;
  }
}

// Scaled to about unit length first, so that no square overflows or vanishes.
DQuat unit_quaternion(const double xyzw[4], const char* name) {
  double largest = 0.0;
  for (int i = 0; i < 4; ++i) {
    if (!std::isfinite(xyzw[i])) refuse_argument(name, ".orientation is not finite");
    largest = std::max(largest, std::abs(xyzw[i]));
  }
  if (largest == 0.0) refuse_argument(name, ".orientation is zero");
  return glm::normalize(DQuat(xyzw[3] / largest, xyzw[0] / largest, xyzw[1] / largest, xyzw[2] / largest));
}

}  // namespace

Space::Space(const plp_space& space, const char* name) : metres_per_unit_(space.metres_per_unit) {
  require_axes(space, name);
  if (space.reserved != 0) refuse_argument(name, ".reserved is not zero");
  if (!(metres_per_unit_ >= kSmallestUnit && metres_per_unit_ <= kLargestUnit)) {
    refuse_argument(name, ".metres_per_unit is not within 1e-9 and 1e9");
  }
  DMat3 matrix(0.0);
  for (int i = 0; i < 3; ++i) {
    axis_[i] = std::abs(space.axes[i]) - 1;
    sign_[i] = space.axes[i] < 0 ? -1.0 : 1.0;
    matrix[i][axis_[i]] = sign_[i];
  }
  determinant_ = glm::determinant(matrix);
}

plp_space Space::given() const {
  plp_space space{};
  for (int i = 0; i < 3; ++i) space.axes[i] = (sign_[i] < 0.0 ? -1 : 1) * (axis_[i] + 1);
  space.metres_per_unit = metres_per_unit_;
  return space;
}

Pose Space::pose_in(const plp_pose& pose, const char* name) const {
  const DVec3 translation = point_in(vector_of(pose.position));
  if (!in_range(translation)) refuse_argument(name, ".position is not three numbers of at most 1e15 m");
  const DQuat unit = unit_quaternion(pose.orientation, name);
  const DVec3 axis = determinant_ * turned_in({unit.x, unit.y, unit.z});
  return {glm::mat3_cast(DQuat(unit.w, axis)), translation};
}

void Space::point_out(const DVec3& point, double out[3]) const {
  store(turned_out(point) / metres_per_unit_, out);
}

void Space::direction_out(const DVec3& direction, double out[3]) const {
  store(turned_out(direction), out);
}

plp_wrench Space::wrench_out(const Wrench& wrench) const {
  plp_wrench out{};
  direction_out(wrench.force, out.force);
  direction_out(determinant_ * wrench.torque, out.torque);
  return out;
}

plp_pose Space::pose_out(const Pose& pose) const {
  plp_pose out;
  point_out(pose.translation, out.position);
  const DQuat unit = glm::normalize(glm::quat_cast(pose.rotation));
  direction_out(determinant_ * DVec3(unit.x, unit.y, unit.z), out.orientation);
  out.orientation[3] = unit.w;
  return out;
}

DVec3 Space::turned_in(const DVec3& vector) const {
  DVec3 turned;
  for (int i = 0; i < 3; ++i) turned[axis_[i]] = sign_[i] * vector[i];
  return turned;
}

DVec3 Space::turned_out(const DVec3& vector) const {
  DVec3 turned;
  for (int i = 0; i < 3; ++i) turned[i] = sign_[i] * vector[axis_[i]];
  return turned;
}

}  // namespace palpate::capi
