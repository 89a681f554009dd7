#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "engine/gltf/load_error.h"

namespace palpate::gltf {

// glTF's component types, by their OpenGL numbers.
enum ComponentType : int {
  kInt8 = 5120,
  kUint8 = 5121,
  kInt16 = 5122,
  kUint16 = 5123,
  kUint32 = 5125,
  kFloat32 = 5126,
};

// Calls work(T{}) with the C++ type of `type`.
template <class Work>
auto with_component_type(int type, Work&& work) {
  switch (type) {
    case kInt8:
      return work(std::int8_t{});
    case kUint8:
      return work(std::uint8_t{});
    case kInt16:
      return work(std::int16_t{});
    case kUint16:
      return work(std::uint16_t{});
    case kUint32:
      return work(std::uint32_t{});
    case kFloat32:
      return work(float{});
    default:
      fail(ErrorCode::kBadFormat, "component type ", type, " is not known");
  }
}

// The value of a component; normalized integers stand for [0, 1] or [−1, 1] by the equations of glTF 2.0.
template <class T>
double number_of(T value, bool normalized) {
  if constexpr (std::is_floating_point_v<T>) {
    return value;
  } else {
    if (!normalized) return static_cast<double>(value);
    return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
  }
}

}  // namespace palpate::gltf
