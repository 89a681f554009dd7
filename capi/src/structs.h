#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

#include "capi/src/errors.h"

namespace palpate::capi {

// The size of each growing struct in the version that brought it: none may be smaller. A struct that grows
// keeps its number here.
template <class T>
inline constexpr std::uint32_t kFirstSize = 0;
template <>
inline constexpr std::uint32_t kFirstSize<plp_model_options> = 32;
template <>
inline constexpr std::uint32_t kFirstSize<plp_triangles> = 88;
template <>
inline constexpr std::uint32_t kFirstSize<plp_model_info> = 288;
template <>
inline constexpr std::uint32_t kFirstSize<plp_contacts> = 216;
template <>
inline constexpr std::uint32_t kFirstSize<plp_query_options> = 48;
template <>
inline constexpr std::uint32_t kFirstSize<plp_scene_options> = 56;
template <>
inline constexpr std::uint32_t kFirstSize<plp_body_options> = 104;
template <>
inline constexpr std::uint32_t kFirstSize<plp_body_info> = 312;
template <>
inline constexpr std::uint32_t kFirstSize<plp_gltf_scene_options> = 88;
template <>
inline constexpr std::uint32_t kFirstSize<plp_servo_options> = 24;
template <>
inline constexpr std::uint32_t kFirstSize<plp_servo_state> = 160;
template <>
inline constexpr std::uint32_t kFirstSize<plp_device_info> = 712;
template <>
inline constexpr std::uint32_t kFirstSize<plp_device_state> = 384;
template <>
inline constexpr std::uint32_t kFirstSize<plp_safety_limits> = 80;
template <>
inline constexpr std::uint32_t kFirstSize<plp_hand_options> = 200;
template <>
inline constexpr std::uint32_t kFirstSize<plp_device_mapping> = 144;
template <>
inline constexpr std::uint32_t kFirstSize<plp_recording> = 32;
template <>
inline constexpr std::uint32_t kFirstSize<plp_trace_info> = 48;
template <>
inline constexpr std::uint32_t kFirstSize<plp_trace_body> = 112;
template <>
inline constexpr std::uint32_t kFirstSize<plp_trace_tick> = 296;

// No version will need more; a larger size is taken for garbage and not read.
inline constexpr std::uint32_t kLargestSize = 4096;

// The struct_size of a caller's struct. It is refused if no version has it.
template <class T>
std::uint32_t checked_size(const T* pointer, const char* name) {
  static_assert(std::is_trivially_copyable_v<T> && kFirstSize<T> != 0 && sizeof(T) >= kFirstSize<T>);
  if (!pointer) refuse_argument(name, " is null");
  const std::uint32_t size = pointer->struct_size;
  if (size < kFirstSize<T> || size > kLargestSize) {
    refuse(ErrorCode::kInvalidArgument, std::string(name) + "->struct_size is " + std::to_string(size) +
                                            ", which no version has; call the struct's init function");
  }
  return size;
}

// A copy of a caller's input struct as this version knows it. A longer struct of a later version is accepted
// while all that this version does not know is zero.
template <class T>
T read_struct(const T* input, const char* name) {
  const std::uint32_t size = checked_size(input, name);
  const auto* bytes = reinterpret_cast<const unsigned char*>(input);
  if (size > sizeof(T) &&
      std::any_of(bytes + sizeof(T), bytes + size, [](unsigned char b) { return b != 0; })) {
    refuse_argument(name, " sets fields that this version does not have");
  }
  T copy{};
  std::memcpy(&copy, input, std::min<std::size_t>(size, sizeof(T)));
  return copy;
}

// Writes as much as the caller's struct has room for and keeps its struct_size.
template <class T>
void write_struct(T value, T* output, const char* name) {
  const std::uint32_t size = checked_size(output, name);
  value.struct_size = size;
  std::memcpy(static_cast<void*>(output), &value, std::min<std::size_t>(size, sizeof(T)));
}

// Fills a caller's struct of `size` bytes, which is what its program was built with: a program with an older
// header is not overrun, and what only a newer header has is zero.
template <class T>
void fill_struct(T value, T* output, std::size_t size) {
  if (!output || size < sizeof value.struct_size || size > kLargestSize) return;
  value.struct_size = static_cast<std::uint32_t>(size);
  std::memset(static_cast<void*>(output), 0, size);
  std::memcpy(static_cast<void*>(output), &value, std::min(size, sizeof(T)));
}

// The number in an enum field, which a caller may have filled with any.
template <class Enum>
std::int32_t raw_enum(const Enum& field) {
  static_assert(sizeof(Enum) == sizeof(std::int32_t));
  std::int32_t raw;
  std::memcpy(&raw, &field, sizeof raw);
  return raw;
}

}  // namespace palpate::capi
