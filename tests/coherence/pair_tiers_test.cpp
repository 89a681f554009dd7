// Tiers of pairs of features: none may be forgotten, and none be due after its certificate has passed.
#include "engine/snch/pair_tiers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 41;

// Two models that move along and turn, so that an odometer reads something.
class Motion {
 public:
  Motion() { odometer_.start(placement()); }

  void advance(double step) {
    place_ += step;
    odometer_.advance(placement());
  }
  void reset() { odometer_.reset(); }
  Readings readings() const { return Readings(odometer_); }
  const Odometer& odometer() const { return odometer_; }

 private:
  Placement placement() const {
    Pose pose;
    pose.rotation = glm::mat3_cast(glm::angleAxis(0.3 * place_, DVec3(0, 0, 1)));
    pose.translation = {place_, 0, 0};
    return {ModelFrame{}, ModelFrame{}, pose};
  }

  double place_ = 0.0;
  Odometer odometer_{DVec3(0.0), 0.5};
};

// Each pair of features with what is left of its certificate.
using Left = std::array<Certificate, FeaturePairSet::kCount>;

Certificate random_certificate(Random& random) {
  const double length = std::pow(10.0, random.uniform(-5.0, 0.0));
  switch (random.below(4)) {
    case 0:
      return Certificate::within_distance(length);
    case 1:
      return Certificate::within_angle(length);
    case 2:
      return {length, length * random.uniform(0.1, 2.0)};
    default:
      return random.below(3) == 0 ? Certificate{} : Certificate::forever();
  }
}

FeaturePairSet random_pairs(Random& random) {
  FeaturePairSet pairs;
  pairs.add(FeaturePairSet::kContact);
  for (int pair = 0; pair < FeaturePairSet::kContact; ++pair)
    if (random.below(3) == 0) pairs.add(pair);
  return pairs;
}

TEST(PairTiers, EachIsDueBeforeItsCertificateHasPassed) {
  Random random(kSeed);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round);
    Motion motion;
    PairTiers tiers;
    ASSERT_TRUE(tiers.untested());
    const FeaturePairSet all = random_pairs(random);
    FeaturePairSet due = all;
    Left left{};
    int tested = 0, ticks = 0;
    for (; ticks < 200; ++ticks) {
      PairCertificates certificates;
      certificates.clear(true);
      due.for_each([&](int pair) {
        ++tested;
        // Contact is sure: what may touch is a case of its own.
        left[static_cast<std::size_t>(pair)] = pair == FeaturePairSet::kContact
                                                   ? Certificate::within_distance(0.01)
                                                   : random_certificate(random);
        certificates.set(pair, left[static_cast<std::size_t>(pair)]);
      });
      tiers.renew(certificates, motion.odometer().rate(), motion.readings());
      ASSERT_FALSE(tiers.untested());
      const double distance = motion.odometer().distance(), angle = motion.odometer().angle();
      motion.advance(random.uniform(0.0, 2e-3));
      all.for_each([&](int pair) {
        Certificate& of = left[static_cast<std::size_t>(pair)];
        of.distance -= motion.odometer().distance() - distance;
        of.angle -= motion.odometer().angle() - angle;
      });
      if (random.below(20) == 0) {
        tiers.set_back(motion.readings());
        motion.reset();
      }
      due = tiers.due(motion.readings().now());
      ASSERT_EQ(due.empty(), !tiers.first().has_passed(motion.readings().now()));
      all.for_each([&](int pair) {
        const Certificate& of = left[static_cast<std::size_t>(pair)];
        EXPECT_TRUE(due.has(pair) || of.holds()) << pair;
      });
      if (HasFailure()) return;
    }
    int pairs = 0;
    all.for_each([&](int) { ++pairs; });
    EXPECT_LT(tested, pairs * ticks) << "all are always due";
  }
}

TEST(PairTiers, AllAreDueWhileTheTrianglesMayTouch) {
  Random random(kSeed);
  Motion motion;
  PairTiers tiers;
  PairCertificates certificates;
  certificates.clear(true);
  FeaturePairSet::all().for_each([&](int pair) { certificates.set(pair, Certificate::forever()); });
  tiers.renew(certificates, motion.odometer().rate(), motion.readings());
  EXPECT_TRUE(tiers.due(motion.readings().now()).empty());
  certificates.set(FeaturePairSet::kContact, Certificate{});
  tiers.renew(certificates, motion.odometer().rate(), motion.readings());
  EXPECT_EQ(tiers.due(motion.readings().now()), FeaturePairSet::all());
}

}  // namespace
}  // namespace palpate
