#pragma once

#include <cstdint>

#include "engine/kernel/triangle_pair.h"

namespace palpate {

// A node of a tree by its index, or one feature of a leaf's triangle: its face, or a side or corner that it
// owns. Where the other model is much finer, features have narrower bounds than the triangle has.
class FeatureNode {
 public:
  static constexpr std::uint32_t kMostNodes = 1u << 29;  // only so many can be told apart

  explicit constexpr FeatureNode(std::uint32_t code) : code_(code) {}

  static constexpr std::uint32_t code_of(std::uint32_t leaf, TrianglePlace place) {
    return leaf | (place.code + 1u) << kShift;
  }

  constexpr std::uint32_t node() const { return code_ & (kMostNodes - 1); }
  constexpr bool is_feature() const { return code_ >= kMostNodes; }
  constexpr TrianglePlace place() const { return {static_cast<std::uint8_t>((code_ >> kShift) - 1)}; }

 private:
  static constexpr unsigned kShift = 29;

  std::uint32_t code_;
};

}  // namespace palpate
