#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "engine/math/cone.h"
#include "engine/snch/node.h"

namespace palpate {

// Positive floats below 2 as their exponent and first bits: those from 2^-63 on in 20 bits, 14 of them
// mantissa, or, coarser by 16, in the first 16 of these.
struct FloatCode {
  static constexpr std::uint32_t kLeast = std::bit_cast<std::uint32_t>(0x1p-63f);
  static constexpr int kDropped = 9;  // bits of a float32's mantissa

  static float decoded(std::uint32_t code) { return std::bit_cast<float>((code << kDropped) + kLeast); }

  // The least code of no less than x, which is below 2, with `spare` more bits zero.
  static std::uint32_t rounded_up(double x, int spare = 0) {
    float least = static_cast<float>(x);
    if (least < x) least = std::nextafter(least, 2.0f);
    const std::uint32_t bits = std::max(std::bit_cast<std::uint32_t>(least), kLeast) - kLeast;
    const std::uint32_t step = 1u << (kDropped + spare);
    return (bits + step - 1) / step << spare;
  }
};

// A node as a tree keeps it, two in a cache line. The box, the sphere and the cone are rounded outward to
// what has room: by less than 1/16,000, and the cone's angle by 1/1,000 and 7e-5 radians.
struct alignas(32) PackedNode {
  Vec3 centre;
  std::uint32_t link;
  std::uint16_t half[3];  // FloatCode, the upper 16 bits
  std::uint16_t radius;
  std::uint16_t low_bits;   // the lower four of half[0], half[1], half[2] and radius, from the lowest
  std::uint16_t cone;       // the tangent of half its angle: FloatCode, the upper 16 bits; or kWhole
  std::uint16_t octant[2];  // the axis on an octahedron that is unfolded into a square [Cigolle et al. 2014]

  static constexpr std::uint16_t kWhole = 0xFFFF;
  static constexpr std::uint32_t kRightAngle = 63u << 10;  // all cones are narrower, or whole
  static constexpr int kOctantCentre = 32767;

  // What the cosine of a narrow cone's angle is taken from, so that it is rounded down.
  static constexpr float kBelowOne = 0x1.fffffep-1f;

  PackedNode() = default;
  PackedNode(std::uint32_t link, const Vec3& centre) : centre(centre), link(link) {}

  void set_box(const DVec3& half_size, double sphere_radius);
  void set_cone(const Cone& around);

  bool is_leaf() const { return (link & Node::kLeaf) != 0; }
  std::uint32_t triangle() const { return link & ~Node::kLeaf; }
  std::uint32_t second_child() const { return link; }
  bool cone_is_whole() const { return cone == kWhole; }
  Vec3 half_size() const { return {length(half[0], 0), length(half[1], 4), length(half[2], 8)}; }
  float sphere_radius() const { return length(radius, 12); }
  Vec3 cone_axis() const;
  Node unpacked() const;

 private:
  float length(std::uint32_t upper, int low) const {
    return FloatCode::decoded(upper << 4 | (low_bits >> low & 15u));
  }
};
static_assert(sizeof(PackedNode) == 32);

// As the wide tests of node pairs decode it, operation by operation.
inline Vec3 PackedNode::cone_axis() const {
  constexpr float kStep = 1.0f / kOctantCentre;
  float x = static_cast<float>(octant[0] - kOctantCentre) * kStep;
  float y = static_cast<float>(octant[1] - kOctantCentre) * kStep;
  const float z = (1.0f - std::abs(x)) - std::abs(y);
  const float fold = std::max(-z, 0.0f);
  x -= std::copysign(fold, x);
  y -= std::copysign(fold, y);
  const float shrink = 1.0f / std::sqrt(x * x + y * y + z * z);
  return {x * shrink, y * shrink, z * shrink};
}

inline Node PackedNode::unpacked() const {
  Node node{centre, sphere_radius(), half_size(), -1.0f, cone_axis(), 0.0f, link};
  if (cone_is_whole()) return node;
  const float t = FloatCode::decoded(std::uint32_t{cone} << 4), squared = t * t;
  const float share = 2.0f / (1.0f + squared);
  node.cone_cosine = kBelowOne - share * squared;
  node.cone_sine = share * t;
  return node;
}

}  // namespace palpate
