#pragma once

#include "engine/contact/spring.h"
#include "engine/math/pose.h"
#include "palpate/palpate.h"

namespace palpate::capi {

// Converts between a caller's space and Palpate's: a signed permutation M of the axes and a unit of length. A
// rotation R becomes M R Mᵀ; axes of rotation and torques are pseudo-vectors and turn by det(M) M.
class Space {
 public:
  Space() = default;  // Palpate's own
  // Refuses axes that are not ±1, ±2, ±3, each once, and units of length outside [1e-9, 1e9] m.
  Space(const plp_space& space, const char* name);

  plp_space given() const;  // what it was made of

  bool mirrored() const { return determinant_ < 0.0; }

  double length_in(double length) const { return length * metres_per_unit_; }
  DVec3 point_in(const DVec3& point) const { return metres_per_unit_ * turned_in(point); }
  // Refuses a pose that is not finite or whose quaternion is zero. `name` is what the sentence calls it.
  Pose pose_in(const plp_pose& pose, const char* name) const;

  double length_out(double length) const { return length / metres_per_unit_; }
  void point_out(const DVec3& point, double out[3]) const;
  void direction_out(const DVec3& direction, double out[3]) const;  // forces, too: they stay in newtons
  plp_wrench wrench_out(const Wrench& wrench) const;
  plp_pose pose_out(const Pose& pose) const;

 private:
  DVec3 turned_in(const DVec3& vector) const;
  DVec3 turned_out(const DVec3& vector) const;

  int axis_[3] = {0, 1, 2};  // Palpate's axis along which the space's i-th points
  double sign_[3] = {1.0, 1.0, 1.0};
  double determinant_ = 1.0;
  double metres_per_unit_ = 1.0;
};

inline constexpr plp_space kPalpateSpace = {{1, 2, 3}, 0, 1.0};

inline void store(const DVec3& vector, double out[3]) {
  for (int i = 0; i < 3; ++i) out[i] = vector[i];
}

inline DVec3 vector_of(const double numbers[3]) {
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace palpate::capi
