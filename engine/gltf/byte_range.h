#pragma once

#include <cstdint>
#include <limits>

namespace palpate::gltf {

// Whether bytes [offset, offset + length) lie in [0, total); no sum can overflow.
constexpr bool range_fits(std::uint64_t offset, std::uint64_t length, std::uint64_t total) {
  return offset <= total && length <= total - offset;
}

// a · b, or the largest value if the product does not fit.
constexpr std::uint64_t saturated_product(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();
  return b != 0 && a > kLargest / b ? kLargest : a * b;
}

}  // namespace palpate::gltf
