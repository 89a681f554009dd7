// Certificates of pairs of features: while one holds, no motion whatever brings a minimum, or contact.
#include "engine/snch/feature_certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "engine/snch/owned_triangle.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 61;
constexpr double kCutoff = 0.02;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kRounds = 1000;
#else
constexpr int kRounds = 12000;
#endif

struct Models {
  const char* a;
  const char* b;
};

void PrintTo(const Models& models, std::ostream* out) {
  *out << models.a << " - " << models.b;
}

class FeatureCertificates : public testing::TestWithParam<Models> {
 protected:
  // Two triangles near each other, as often as not face to face.
  Pose random_pose(std::uint32_t triangle_a, std::uint32_t triangle_b) {
    const Mesh &a = a_->mesh(), &b = b_->mesh();
    Pose pose;
    pose.rotation = random_.rotation();
    if (random_.below(4) != 0) {
      const DVec3 to = -unit_normal(a, triangle_a), from = pose.rotation * unit_normal(b, triangle_b);
      const double lean = random_.below(2) == 0 ? 0.3 : 0.03;
      pose.rotation = turn_between(from, glm::normalize(to + lean * random_.direction())) * pose.rotation;
    }
    const DVec3 on_a = random_point(triangle_of(a, triangle_a)),
                on_b = random_point(triangle_of(b, triangle_b));
    const DVec3 away = kCutoff * random_.uniform(0.0, 1.0) *
                       glm::normalize(unit_normal(a, triangle_a) + 0.3 * random_.direction());
    pose.translation = (on_a + away) * a.frame.scale + a.frame.origin -
                       pose.rotation * (on_b * b.frame.scale + b.frame.origin);
    return pose;
  }

  static DMat3 turn_between(const DVec3& from, const DVec3& to) {
    const DVec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis);
    if (!(sine > 1e-9)) return DMat3(1.0);
    return glm::mat3_cast(glm::angleAxis(std::atan2(sine, glm::dot(from, to)), axis / sine));
  }
  DVec3 random_point(const Triangle& t) {
    const double u = random_.uniform(-0.2, 1.2), v = random_.uniform(-0.2, 1.2);
    return t.corner[0] + u * (t.corner[1] - t.corner[0]) + v * (t.corner[2] - t.corner[0]);
  }

  // A motion that an odometer reads as no more than this.
  Pose moved(const Pose& pose, const Certificate& within, double reach) {
    const Mesh &a = a_->mesh(), &b = b_->mesh();
    const double distance = std::min(within.distance, 0.5), share = random_.below(3) * 0.5;
    const double chord = std::min(1.0, (1.0 - share) * distance / reach);
    const double angle = std::min(2.0 * std::asin(0.5 * chord), std::min(within.angle, 0.5));
    const DMat3 turn = glm::mat3_cast(glm::angleAxis(angle, random_.direction()));
    const DVec3 centre = pose * b_->centre();
    Pose next;
    next.rotation = turn * pose.rotation;
    next.translation =
        centre + random_.direction() * (share * distance * a.frame.scale) - next.rotation * b_->centre();
    Odometer odometer((b_->centre() - b.frame.origin) / b.frame.scale, reach);
    odometer.start({a.frame, b.frame, pose});
    odometer.advance({a.frame, b.frame, next});
    EXPECT_LE(odometer.distance(), distance * (1 + 1e-9) + 1e-12);
    EXPECT_LE(odometer.angle(), within.angle * (1 + 1e-9) + 1e-12);
    return next;
  }

  struct At {
    Placement placement;
    TestedTriangle a;
    TestedTriangle b;
    FeaturePairTest::Limits limits;
  };
  At at(const Pose& pose, std::uint32_t triangle_a, std::uint32_t triangle_b) const {
    const Mesh &a = a_->mesh(), &b = b_->mesh();
    const Placement placement(a.frame, b.frame, pose);
    return {placement,
            owned_triangle(a_->tree(), a, triangle_a),
            owned_triangle(b_->tree(), b, triangle_b, placement),
            {kCutoff, touching_distance(placement), SearchOptions::kWidestTolerance}};
  }

  // What a pair of features holds, or whether the triangles touch.
  bool holds(const At& at, int pair) {
    if (pair == FeaturePairSet::kContact) return triangles_touch(at.a.shape, at.b.shape, at.limits.touch);
    FeaturePairSet among;
    among.add(pair);
    std::vector<Minimum> found;
    FeaturePairTest(a_->mesh(), b_->mesh(), at.placement, at.limits, found)(at.a, at.b, among);
    return !found.empty();
  }

  std::shared_ptr<const Model> a_ = asset_model(GetParam().a), b_ = asset_model(GetParam().b, 0.5);
  Random random_{kSeed};
};

TEST_P(FeatureCertificates, HoldWhateverTheMotion) {
  const Mesh &a = a_->mesh(), &b = b_->mesh();
  const double reach = b_->radius() / a.frame.scale + kCutoff;
  int certified = 0, moves = 0, holding = 0, beyond = 0;
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round);
    const auto triangle_a = static_cast<std::uint32_t>(random_.below(a.triangles.size())),
               triangle_b = static_cast<std::uint32_t>(random_.below(b.triangles.size()));
    const Pose pose = random_pose(triangle_a, triangle_b);
    const At start = at(pose, triangle_a, triangle_b);
    const MotionRate rate(random_.uniform(1e-5, 1e-3), random_.uniform(1e-5, 1e-3));
    const FeatureCertificate certificate(a, b, start.placement, start.limits, rate, reach);
    const bool watched = random_.below(4) != 0;
    FeaturePairSet among = FeaturePairSet::all();
    PairCertificates certificates;
    const Certificate far = certificate(start.a, start.b, among, watched, certificates);
    if (far.holds()) certificates.clear(watched);
    Certificate contact = Certificate::forever();
    certificates.for_each([&](int pair, const Certificate& one) {
      if (watched && pair == FeaturePairSet::kContact) contact = one;
    });
    const auto expect_none = [&](int pair, const Certificate& one) {
      ++certified;
      EXPECT_FALSE(holds(start, pair)) << pair;
      for (int i = 0; i < 3; ++i, ++moves) {
        const At there = at(moved(pose, both(one, contact), reach), triangle_a, triangle_b);
        EXPECT_FALSE(holds(there, pair)) << pair << " after move " << i;
      }
      const Certificate more{8 * one.distance, 8 * one.angle};
      beyond += holds(at(moved(pose, more, reach), triangle_a, triangle_b), pair);
    };
    if (far.holds()) {
      among.for_each([&](int pair) { expect_none(pair, far); });
    } else {
      certificates.for_each([&](int pair, const Certificate& one) {
        if (one.holds() && contact.holds())
          expect_none(pair, one);
        else
          holding += holds(start, pair);
      });
    }
    if (HasFailure()) return;
  }
  std::printf("%d certificates, %d moves within, %d minima or contacts beyond, %d without one\n", certified,
              moves, beyond, holding);
  EXPECT_GT(certified, kRounds);
  EXPECT_GT(beyond, 0);
  EXPECT_GT(holding, 0);
}

INSTANTIATE_TEST_SUITE_P(Assets, FeatureCertificates,
                         testing::Values(Models{"torus", "teapot_5600"}, Models{"crankshaft_45k", "gear_6k"},
                                         Models{"saddle", "fan_200"}, Models{"voxels", "box_tessellated"},
                                         Models{"open_sheet", "mobius_strip"},
                                         Models{"two_sided_sheet", "cylinder"}));

}  // namespace
}  // namespace palpate
