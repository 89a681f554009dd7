// What pushes from step to step when LMDs come and go.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/scene/pair_springs.h"

namespace palpate {
namespace {

constexpr double kCutoff = 0.01;

Lmd lmd(std::uint32_t feature, const DVec3& at, double distance, std::uint32_t set = 0, double weight = 1.0) {
  const Feature a{FeatureKind::kFace, feature}, b{FeatureKind::kVertex, feature};
  return {at, at + DVec3(0.0, 0.0, distance), {0.0, 0.0, 1.0}, distance, weight, set, a, b};
}

class FadeTest : public testing::Test {
 protected:
  // One millisecond later; fading takes ten.
  std::span<const PairSpring> step(const std::vector<Lmd>& present, double height = 0.0) {
    situation_.body_from_tool.translation.z = height;
    springs_.update(present, situation_);
    return springs_.list();
  }
  // Springs of 1 N/m.
  double force() const {
    double sum = 0.0;
    for (const PairSpring& spring : springs_.list())
      sum += spring.at.weight * std::max(0.0, kCutoff - spring.at.distance);
    return sum;
  }

  PairSprings springs_;
  SpringSituation situation_{{}, kCutoff, 0.001, 0.01, false, true};
};

TEST_F(FadeTest, ALostSpringFadesInTheStatedTime) {
  const Lmd stays = lmd(1, {0.0, 0.0, 0.0}, 0.002), goes = lmd(2, {0.05, 0.0, 0.0}, 0.004, 1);
  step({stays, goes});
  EXPECT_EQ(springs_.list().size(), 2u);
  for (int i = 1; i <= 12; ++i) {
    step({stays});
    EXPECT_NEAR(force(), 0.008 + 0.006 * std::max(0.0, 1.0 - 0.1 * i), 1e-12) << "step " << i;
    EXPECT_EQ(springs_.list().size(), i < 10 ? 2u : 1u) << "step " << i;
  }
}

TEST_F(FadeTest, WhatFadesMovesWithTheTool) {
  step({lmd(1, DVec3(0.0), 0.004)});
  step({}, 0.001);
  ASSERT_EQ(springs_.list().size(), 1u);
  EXPECT_TRUE(springs_.list()[0].is_held);
  EXPECT_NEAR(springs_.list()[0].at.distance, 0.005, 1e-15);
  EXPECT_NEAR(springs_.list()[0].velocity.z, 1.0, 1e-9);
  EXPECT_NEAR(springs_.list()[0].at.weight, 0.9, 1e-12);
  step({}, 0.0065);
  EXPECT_TRUE(springs_.list().empty()) << "it is out of the cutoff";
}

TEST_F(FadeTest, ASpringThatLeavesThroughTheCutoffIsGone) {
  step({lmd(1, DVec3(0.0), 0.0099)});
  step({}, 0.0002);
  EXPECT_TRUE(springs_.list().empty());
}

TEST_F(FadeTest, ASpringFoundLateComesInGradually) {
  step({});
  for (int i = 1; i <= 12; ++i) {
    step({lmd(1, DVec3(0.0), 0.004)});
    EXPECT_NEAR(force(), 0.006 * std::min(1.0, 0.1 * i), 1e-12) << "step " << i;
  }
}

TEST_F(FadeTest, ASpringThatHasJustBegunIsThereAtOnce) {
  step({});
  step({lmd(1, DVec3(0.0), 0.0098)});
  EXPECT_NEAR(force(), 0.0002, 1e-15);
  step({lmd(1, DVec3(0.0), 0.004)}, -0.0058);
  EXPECT_NEAR(force(), 0.006, 1e-15) << "it goes on";
}

TEST_F(FadeTest, TheFirstStepHasNothingToComeFrom) {
  step({lmd(1, DVec3(0.0), 0.001)});
  EXPECT_NEAR(force(), 0.009, 1e-15);
}

TEST_F(FadeTest, ASpringThatMovesToOtherFeaturesGoesOn) {
  step({lmd(1, DVec3(0.0), 0.004), lmd(2, {0.05, 0.0, 0.0}, 0.003, 1)});
  step({lmd(3, {0.0501, 0.0, 0.0}, 0.003), lmd(4, {0.0001, 0.0, 0.0}, 0.004, 1)});
  EXPECT_EQ(springs_.list().size(), 2u);
  EXPECT_NEAR(force(), 0.006 + 0.007, 1e-15);
}

TEST_F(FadeTest, APlateauGoesOnAsAWhole) {
  const auto at = [](std::uint32_t i) { return lmd(i, {0.02 * i, 0.0, 0.0}, 0.004, 0, 0.25); };
  step({at(0), at(1), at(2), at(3)});
  step({lmd(2, {0.04, 0.0, 0.0}, 0.004, 0, 0.5), lmd(9, {0.3, 0.0, 0.0}, 0.004, 0, 0.5)});
  EXPECT_EQ(springs_.list().size(), 2u);
  EXPECT_NEAR(force(), 0.006, 1e-15);
}

// Of the complete set, what is not there is nowhere: the law alone decides.
TEST_F(FadeTest, NothingFadesWhileTheSetIsComplete) {
  situation_.may_lose = false;
  step({lmd(1, DVec3(0.0), 0.004)});
  step({});
  EXPECT_TRUE(springs_.list().empty());
  step({lmd(1, DVec3(0.0), 0.004)});
  EXPECT_NEAR(force(), 0.006, 1e-15);
}

TEST_F(FadeTest, FadingEndsWhenTheSetIsComplete) {
  step({lmd(1, DVec3(0.0), 0.004)});
  step({lmd(2, {0.05, 0.0, 0.0}, 0.003)});
  EXPECT_NEAR(force(), 0.9 * 0.006 + 0.1 * 0.007, 1e-12);
  situation_.may_lose = false;
  step({lmd(2, {0.05, 0.0, 0.0}, 0.003)});
  EXPECT_NEAR(force(), 0.007, 1e-15);
}

TEST_F(FadeTest, NoTimeToFadeIsAtOnce) {
  situation_.fade_time = 0.0;
  step({lmd(1, DVec3(0.0), 0.004)});
  step({lmd(2, {0.05, 0.0, 0.0}, 0.003)});
  EXPECT_EQ(springs_.list().size(), 1u);
  EXPECT_NEAR(force(), 0.007, 1e-15);
}

TEST_F(FadeTest, ListsAreBounded) {
  std::vector<Lmd> many(300);
  for (std::uint32_t i = 0; i < many.size(); ++i) many[i] = lmd(i, {0.02 * i, 0.0, 0.0}, 0.004, i);
  step(many);
  step({});
  EXPECT_EQ(springs_.list().size(), kMostHeld);
}

TEST_F(FadeTest, AnUnmovedToolHasNoVelocity) {
  situation_.body_from_tool.rotation = glm::mat3_cast(glm::normalize(DQuat(0.1, 0.2, 0.3, 0.9)));
  for (int i = 0; i < 3; ++i) {
    step({lmd(1, {0.3, 0.7, 0.1}, 0.004)}, 0.123);
    EXPECT_EQ(springs_.list()[0].velocity, DVec3(0.0));
  }
}

}  // namespace
}  // namespace palpate
