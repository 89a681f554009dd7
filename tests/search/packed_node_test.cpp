// What a packed node bounds holds what it was given, and not much more.
#include "engine/snch/packed_node.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 20011;
constexpr int kRounds = 100'000;

// The length of an arc on the unit sphere, accurate also where it is short.
double angle_between(const DVec3& one, const DVec3& other) {
  return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

TEST(PackedNode, RoundsLengthsUpByLittle) {
  Random random(kSeed);
  for (int i = 0; i < kRounds; ++i) {
    DVec3 half;
    for (int k = 0; k < 3; ++k) half[k] = std::exp2(random.uniform(-62, 0.5));
    const double radius = std::exp2(random.uniform(-62, 0.5));
    PackedNode packed(0, Vec3(0.0f));
    packed.set_box(half, radius);
    const Node node = packed.unpacked();
    for (int k = 0; k < 3; ++k) {
      ASSERT_GE(node.half[k], half[k]) << "seed " << kSeed << ", round " << i;
      ASSERT_LE(node.half[k], half[k] * (1 + 1.0 / 16000));
    }
    ASSERT_GE(node.radius, radius);
    ASSERT_LE(node.radius, radius * (1 + 1.0 / 16000));
  }
}

TEST(PackedNode, HoldsLengthsBelowItsRange) {
  for (double length : {0.0, 1e-320, 1e-45, 1e-30, 0x1p-63}) {
    PackedNode packed(0, Vec3(0.0f));
    packed.set_box(DVec3(length), length);
    EXPECT_GE(packed.unpacked().radius, length);
    EXPECT_EQ(packed.unpacked().half, Vec3(0x1p-63f));
  }
}

TEST(PackedNode, KeepsCodesInOrder) {
  Random random(kSeed);
  for (int i = 0; i < kRounds; ++i) {
    const double x = std::exp2(random.uniform(-63, 0.9));
    const std::uint32_t code = FloatCode::rounded_up(x);
    ASSERT_GE(FloatCode::decoded(code), x) << "seed " << kSeed << ", round " << i;
    if (code > 0) {
      ASSERT_LT(FloatCode::decoded(code - 1), x);
    }
    ASSERT_EQ(FloatCode::rounded_up(FloatCode::decoded(code)), code);
  }
}

// Cones from a ten-millionth of a radian to a right angle, and axes near the folds of the octahedron.
TEST(PackedNode, WidensConesByLittle) {
  Random random(kSeed);
  for (int i = 0; i < kRounds; ++i) {
    DVec3 axis = random.direction();
    if (i % 4 == 0) axis[i / 4 % 3] *= 1e-6;
    if (i % 8 == 0) axis[i / 8 % 2] *= 1e-7;
    axis = glm::normalize(axis);
    const double angle = 0.5 * std::numbers::pi * std::exp2(-random.uniform(0, 24));
    PackedNode packed(0, Vec3(0.0f));
    packed.set_cone({axis, std::tan(0.5 * angle)});
    const Node node = packed.unpacked();
    const double turned = angle_between(axis, DVec3(node.cone_axis));
    const double tightest = (angle + 7e-5) * 1.001;
    if (tightest > 0.5 * std::numbers::pi && packed.cone_is_whole()) continue;
    ASSERT_GE(node.cone_cosine, 0.0f) << "seed " << kSeed << ", round " << i;
    const double kept = std::atan2(node.cone_sine, node.cone_cosine);
    ASSERT_GE(kept, (angle + turned) * (1 - 1e-6)) << "seed " << kSeed << ", round " << i;
    ASSERT_LE(std::asin(std::min(1.0f, node.cone_sine)), tightest * (1 + 1e-6));
    ASSERT_LE(node.cone_cosine, std::cos(angle + turned) + 1e-7);
    ASSERT_NEAR(glm::length(DVec3(node.cone_axis)), 1.0, 2e-7);
  }
}

TEST(PackedNode, KeepsTheWholeConeWhole) {
  PackedNode packed(0, Vec3(0.0f));
  packed.set_cone(Cone::whole());
  EXPECT_TRUE(packed.cone_is_whole());
  EXPECT_LT(packed.unpacked().cone_cosine, 0.0f);
}

}  // namespace
}  // namespace palpate
