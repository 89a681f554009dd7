#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace palpate {

// An integer of type T out of the bytes from `at` on, which must be there.
template <std::integral T>
constexpr T load_little(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::make_unsigned_t<T> value = 0;
  for (std::size_t i = sizeof(T); i-- > 0;) {
    value = static_cast<std::make_unsigned_t<T>>((static_cast<std::uint64_t>(value) << 8) | bytes[at + i]);
  }
  return static_cast<T>(value);
}

template <std::integral T>
constexpr void store_little(T value, std::span<std::uint8_t> bytes, std::size_t at) {
  const auto bits = static_cast<std::make_unsigned_t<T>>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes[at + i] = static_cast<std::uint8_t>(bits >> (8 * i));
}

}  // namespace palpate
