#pragma once

#include <cmath>

#include "capi/src/errors.h"
#include "engine/math/vector.h"

namespace palpate::capi {

// Lengths in metres and stiffnesses in N/m may be as large as this, so that forces and torques stay finite.
inline constexpr double kLargestNumber = 1e15;

// False for NaN, too.
inline bool in_range(double number) {
  return std::abs(number) <= kLargestNumber;
}

inline bool in_range(const DVec3& vector) {
  return in_range(vector.x) && in_range(vector.y) && in_range(vector.z);
}

// Each returns what it has checked, or refuses and calls it `name`.
inline double checked(double number, const char* name) {
  if (!in_range(number)) refuse_argument(name, " is not a number of at most 1e15");
  return number;
}

inline double checked_positive(double number, const char* name) {
  if (!(checked(number, name) > 0.0)) refuse_argument(name, " is not positive");
  return number;
}

inline double checked_not_negative(double number, const char* name) {
  if (!(checked(number, name) >= 0.0)) refuse_argument(name, " is negative");
  return number;
}

inline DVec3 checked(const DVec3& vector, const char* name) {
  if (!in_range(vector)) refuse_argument(name, " is not three numbers of at most 1e15");
  return vector;
}

}  // namespace palpate::capi
