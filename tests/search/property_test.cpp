// What must not change the set: the order of the models, where and how large they are, how they are numbered.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "assets/catalogue.h"
#include "tests/search/find.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 4242;
constexpr int kPoses = 20;
constexpr double kCutoff = 0.01;  // metres; the models are about 0.2 m long

struct Case {
  const char* a;
  const char* b;
  double b_scale;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.a << " - " << c.b;
}

class Property : public testing::TestWithParam<Case> {
 protected:
  TriangleSoup soup_a = find_asset(GetParam().a)->make();
  TriangleSoup soup_b = scaled(find_asset(GetParam().b)->make(), GetParam().b_scale);
  std::shared_ptr<const Model> a = make_model(soup_a);
  std::shared_ptr<const Model> b = make_model(soup_b);
  Random random{kSeed};

  Pose next_pose() { return place_near(*a, *b, random.uniform(0.0005, 0.008), random); }
};

// The same points, sets and weights in any order, `found` mapped by `map` and lengths by `scale`.
template <class Map>
void expect_same(const LmdSet& expected, const LmdSet& found, double tolerance, double scale,
                 const Map& map) {
  ASSERT_EQ(expected.lmds.size(), found.lmds.size());
  EXPECT_EQ(expected.set_count, found.set_count);
  EXPECT_EQ(expected.overlapping(), found.overlapping());
  for (const Lmd& lmd : found.lmds) {
    const Lmd mapped = map(lmd);
    const auto same = std::any_of(expected.lmds.begin(), expected.lmds.end(), [&](const Lmd& other) {
      return glm::length(other.point_a - mapped.point_a / scale) < tolerance &&
             glm::length(other.point_b - mapped.point_b / scale) < tolerance &&
             std::abs(other.distance - mapped.distance / scale) < tolerance &&
             std::abs(other.weight - mapped.weight) < 1e-6;
    });
    EXPECT_TRUE(same) << "distance " << mapped.distance / scale;
  }
}

Lmd as_is(const Lmd& lmd) {
  return lmd;
}

TEST_P(Property, SwappingTheModelsMirrorsTheSet) {
  for (int i = 0; i < kPoses; ++i) {
    const Pose pose = next_pose();
    const LmdSet forward = find_lmds(*a, *b, pose, kCutoff);
    const LmdSet backward = find_lmds(*b, *a, inverse(pose), kCutoff);
    expect_same(forward, backward, 1e-9, 1.0, [&](Lmd lmd) {
      std::swap(lmd.point_a, lmd.point_b);
      lmd.point_a = pose * lmd.point_a;
      lmd.point_b = pose * lmd.point_b;
      return lmd;
    });
  }
}

TEST_P(Property, RepeatedSearchGivesTheSameBits) {
  LmdSearch search;
  LmdSet first, second;
  SearchOptions options;
  options.cutoff = kCutoff;
  for (int i = 0; i < kPoses; ++i) {
    const Pose pose = next_pose();
    search.run(*a, *b, pose, options, first);
    search.run(*a, *b, pose, options, second);
    ASSERT_EQ(first.lmds.size(), second.lmds.size());
    for (std::size_t k = 0; k < first.lmds.size(); ++k) {
      EXPECT_EQ(first.lmds[k].point_a, second.lmds[k].point_a);
      EXPECT_EQ(first.lmds[k].point_b, second.lmds[k].point_b);
      EXPECT_EQ(first.lmds[k].weight, second.lmds[k].weight);
    }
  }
}

TEST_P(Property, ScaleOnlyScales) {
  for (double scale : {1e-6, 0.25, 1e6}) {
    const auto scaled_a = make_model(scaled(soup_a, scale)), scaled_b = make_model(scaled(soup_b, scale));
    for (int i = 0; i < kPoses; ++i) {
      const Pose pose = next_pose();
      const Pose scaled_pose{pose.rotation, pose.translation * scale};
      expect_same(find_lmds(*a, *b, pose, kCutoff),
                  find_lmds(*scaled_a, *scaled_b, scaled_pose, kCutoff * scale), 2e-6, scale, as_is);
    }
  }
}

TEST_P(Property, DistanceFromTheOriginDoesNotMatter) {
  const DVec3 far(1e4, -2e4, 3e4);
  TriangleSoup moved = soup_a;
  for (DVec3& position : moved.positions) position += far;
  const auto far_a = make_model(moved);
  for (int i = 0; i < kPoses; ++i) {
    const Pose pose = next_pose();
    const Pose far_pose{pose.rotation, pose.translation + far};
    expect_same(find_lmds(*a, *b, pose, kCutoff), find_lmds(*far_a, *b, far_pose, kCutoff), 1e-7, 1.0,
                [&](Lmd lmd) {
                  lmd.point_a -= far;
                  lmd.point_b -= far;
                  return lmd;
                });
  }
}

TEST_P(Property, ATurnOfBothModelsTurnsTheSet) {
  // Cyclic exchange of the axes: a rigid motion that float32 holds exactly.
  DMat3 turn(0.0);
  turn[0][1] = turn[1][2] = turn[2][0] = 1.0;
  TriangleSoup turned_a = soup_a, turned_b = soup_b;
  for (DVec3& position : turned_a.positions) position = turn * position;
  for (DVec3& position : turned_b.positions) position = turn * position;
  const auto model_a = make_model(turned_a), model_b = make_model(turned_b);
  for (int i = 0; i < kPoses; ++i) {
    const Pose pose = next_pose();
    const Pose turned_pose{turn * pose.rotation * glm::transpose(turn), turn * pose.translation};
    expect_same(find_lmds(*a, *b, pose, kCutoff), find_lmds(*model_a, *model_b, turned_pose, kCutoff), 1e-9,
                1.0, [&](Lmd lmd) {
                  lmd.point_a = glm::transpose(turn) * lmd.point_a;
                  lmd.point_b = glm::transpose(turn) * lmd.point_b;
                  return lmd;
                });
  }
}

TriangleSoup renumbered(const TriangleSoup& soup, Random& random) {
  TriangleSoup shuffled;
  std::vector<std::uint32_t> new_place(soup.positions.size());
  std::iota(new_place.begin(), new_place.end(), 0u);
  for (std::size_t i = new_place.size(); i-- > 1;) std::swap(new_place[i], new_place[random.below(i + 1)]);
  shuffled.positions.resize(soup.positions.size());
  for (std::size_t i = 0; i < new_place.size(); ++i) shuffled.positions[new_place[i]] = soup.positions[i];
  for (TriangleIndices t : soup.triangles) {
    for (auto& vertex : t) vertex = new_place[vertex];
    std::rotate(t.begin(), t.begin() + random.below(3), t.end());
    shuffled.triangles.push_back(t);
  }
  for (std::size_t i = shuffled.triangles.size(); i-- > 1;)
    std::swap(shuffled.triangles[i], shuffled.triangles[random.below(i + 1)]);
  return shuffled;
}

TEST_P(Property, NumberingDoesNotMatter) {
  const auto shuffled_a = make_model(renumbered(soup_a, random)),
             shuffled_b = make_model(renumbered(soup_b, random));
  for (int i = 0; i < kPoses; ++i) {
    const Pose pose = next_pose();
    expect_same(find_lmds(*a, *b, pose, kCutoff), find_lmds(*shuffled_a, *shuffled_b, pose, kCutoff), 1e-9,
                1.0, as_is);
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, Property,
                         testing::Values(Case{"organic_2200", "torus", 0.5},
                                         Case{"gear_6k", "icosphere", 0.3}, Case{"voxels", "l_bracket", 0.5},
                                         Case{"saddle", "fan_200", 0.5}));

}  // namespace
}  // namespace palpate
