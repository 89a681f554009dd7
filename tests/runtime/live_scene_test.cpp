// A live scene whose two threads are played by the test, one call at a time.
#include "engine/runtime/live_scene.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

constexpr double kDt = 1e-3;

Contacts newest(LiveScene& scene) {
  Contacts newest;
  scene.visit_newer([&](const Contacts& contacts) { newest = contacts; });
  return newest;
}

Contacts tick(LiveScene& scene) {
  scene.tick(kDt);
  return newest(scene);
}

BodyId add(LiveScene& scene, const std::shared_ptr<const Model>& model, BodyKind kind, const Pose& pose) {
  BodyOptions options;
  options.kind = kind;
  options.model = model;
  options.pose = pose;
  const Result<BodyId> id = scene.add(std::move(options));
  EXPECT_TRUE(id.ok());
  return id.ok() ? id.value() : 0;
}

Pose at(double x, double y, double z) {
  Pose pose;
  pose.translation = {x, y, z};
  return pose;
}

bool same(const Contact& one, const Contact& other) {
  return one.point_a == other.point_a && one.point_b == other.point_b && one.normal == other.normal &&
         one.distance == other.distance && one.weight == other.weight && one.force == other.force &&
         one.body_a == other.body_a && one.set == other.set && one.place_a.triangle == other.place_a.triangle;
}

bool same(const Contacts& one, const Contacts& other) {
  return one.set_count == other.set_count && one.min_distance == other.min_distance &&
         one.overlap == other.overlap && one.overlaps.size() == other.overlaps.size() &&
         one.wrench.force == other.wrench.force && one.wrench.torque == other.wrench.torque &&
         std::equal(one.lmds.begin(), one.lmds.end(), other.lmds.begin(), other.lmds.end(),
                    [](const Contact& a, const Contact& b) { return same(a, b); });
}

// Two of the same bodies, one live.
class LiveSceneTest : public testing::Test {
 protected:
  LiveSceneTest()
      : cutoff_(0.02 * body_->bounds().diagonal()), live_({.cutoff = cutoff_}), still_({.cutoff = cutoff_}) {}

  void fill(const Pose& tool_pose) {
    for (LiveScene* scene : {&live_, &still_}) {
      add(*scene, body_, BodyKind::kStatic, {});
      tool_id_ = add(*scene, tool_, BodyKind::kTool, tool_pose);
    }
  }
  std::vector<Pose> motion(int ticks) {
    constexpr std::uint64_t kSeed = 5;
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    return sliding_motion(*body_, *tool_, cutoff_, 0.2 * body_->bounds().diagonal(), ticks, random);
  }

  const std::shared_ptr<const Model> body_ = asset_model("organic_2200");
  const std::shared_ptr<const Model> tool_ = asset_model("torus");
  const double cutoff_;
  LiveScene live_;
  LiveScene still_;
  BodyId tool_id_ = 0;
};

TEST_F(LiveSceneTest, CertifiedIsBitForBitWhatTheCallerSteps) {
  const std::vector<Pose> poses = motion(250);
  fill(poses[0]);
  ASSERT_TRUE(live_.go_live());
  std::size_t sets = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i == 200) live_.go_still();  // and the caller goes on where the servo ended
    for (LiveScene* scene : {&live_, &still_}) ASSERT_TRUE(scene->set_pose(tool_id_, poses[i]));
    ASSERT_TRUE(still_.step());
    const Contacts expected = newest(still_);
    if (i % 7 == 0 && i < 200) live_.search_globally();
    i < 200 ? live_.tick(kDt) : static_cast<void>(live_.step());
    const Contacts found = newest(live_);
    EXPECT_EQ(found.status, 0u);
    EXPECT_TRUE(same(found, expected)) << "tick " << i;
    sets += found.set_count;
  }
  EXPECT_GT(sets, poses.size());
}

// Out of reach and back, overlapping and apart, however far at once: what was proved before still holds.
TEST_F(LiveSceneTest, LeapsAreTakenToo) {
  Random random(8);
  fill(place_near(*body_, *tool_, 0.5 * cutoff_, random));
  ASSERT_TRUE(live_.go_live());
  std::size_t sets = 0, overlaps = 0, far = 0;
  for (int i = 0; i < 80; ++i) {
    Pose pose = place_near(*body_, *tool_, cutoff_ * random.uniform(-0.5, 1.5), random);
    if (i % 4 == 3) pose.translation *= 5.0;
    for (LiveScene* scene : {&live_, &still_}) ASSERT_TRUE(scene->set_pose(tool_id_, pose));
    ASSERT_TRUE(still_.step());
    const Contacts expected = newest(still_), found = tick(live_);
    EXPECT_EQ(found.status, 0u);
    EXPECT_TRUE(same(found, expected)) << "tick " << i;
    sets += found.set_count;
    overlaps += found.overlap;
    far += found.work.body_pairs == 0;
    if (i % 3 == 0) live_.search_globally();
  }
  EXPECT_GT(sets, 40u);
  EXPECT_GT(overlaps, 5u);
  EXPECT_GT(far, 10u);
}

TEST_F(LiveSceneTest, EveryModeFindsTheSameWhereNothingMoves) {
  fill(motion(1)[0]);
  ASSERT_TRUE(live_.go_live());
  for (const SearchMode mode : {SearchMode::kDescent, SearchMode::kGlobal, SearchMode::kCertified,
                                SearchMode::kDescent, SearchMode::kCertified, SearchMode::kGlobal}) {
    live_.set_mode(mode);
    still_.set_mode(SearchMode::kGlobal);
    for (int i = 0; i < 2; ++i) {
      live_.search_globally();
      tick(live_);
    }
    ASSERT_TRUE(still_.step());
    const Contacts found = tick(live_), expected = newest(still_);
    EXPECT_GT(expected.set_count, 0u);
    EXPECT_EQ(found.set_count, expected.set_count) << static_cast<int>(mode);
    EXPECT_EQ(found.min_distance, expected.min_distance) << static_cast<int>(mode);
  }
}

TEST_F(LiveSceneTest, DescentFollowsTheGlobalSearch) {
  live_.set_mode(SearchMode::kDescent);
  still_.set_mode(SearchMode::kGlobal);
  const std::vector<Pose> poses = motion(200);
  fill(poses[0]);
  ASSERT_TRUE(live_.go_live());
  std::size_t found_sets = 0, all_sets = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (LiveScene* scene : {&live_, &still_}) ASSERT_TRUE(scene->set_pose(tool_id_, poses[i]));
    ASSERT_TRUE(still_.step());
    const Contacts all = newest(still_), found = tick(live_);
    EXPECT_EQ(found.status, 0u);
    EXPECT_LE(found.work.coherence.age, 6u);
    for (const Contact& contact : found.lmds)
      EXPECT_TRUE(std::any_of(all.lmds.begin(), all.lmds.end(),
                              [&](const Contact& other) {
                                return std::abs(other.distance - contact.distance) < 1e-12 &&
                                       glm::length(other.point_b - contact.point_b) < 1e-9;
                              }))
          << "tick " << i;
    found_sets += found.set_count;
    all_sets += all.set_count;
    if (i % 5 == 0) live_.search_globally();
  }
  std::printf("descent found %zu of %zu sets\n", found_sets, all_sets);
  EXPECT_GT(found_sets, all_sets * 9 / 10);
  EXPECT_GE(live_.counts().searches, poses.size() / 5);
}

TEST_F(LiveSceneTest, AnUnmovedSceneIsNotSearchedAgain) {
  live_.set_mode(SearchMode::kDescent);
  fill(motion(1)[0]);
  ASSERT_TRUE(live_.go_live());
  for (int i = 0; i < 3; ++i) tick(live_), live_.search_globally();
  const std::uint64_t searches = live_.counts().searches;
  for (int i = 0; i < 10; ++i) {
    const Contacts found = tick(live_);
    EXPECT_EQ(found.work.body_pairs, 0u);
    EXPECT_GT(found.set_count, 0u);
    EXPECT_FALSE(live_.search_globally());
  }
  EXPECT_EQ(live_.counts().searches, searches);
}

// A hand trembles: a search that goes on with it would take a processor.
TEST_F(LiveSceneTest, AToolThatTremblesIsNotSearchedAgainUntilItMoves) {
  live_.set_mode(SearchMode::kDescent);
  const Pose pose = motion(1)[0];
  fill(pose);
  ASSERT_TRUE(live_.go_live());
  for (int i = 0; i < 3; ++i) tick(live_), live_.search_globally();
  const std::uint64_t searches = live_.counts().searches;
  const auto search_at = [&](double share) {
    const DVec3 aside(share * cutoff_, 0.0, 0.0);
    ASSERT_TRUE(live_.set_pose(tool_id_, Pose{pose.rotation, pose.translation + aside}));
    EXPECT_GT(tick(live_).set_count, 0u);
    live_.search_globally();
  };
  for (int i = 0; i < 50; ++i) search_at(i % 2 ? 0.004 : -0.004);
  EXPECT_EQ(live_.counts().searches, searches);
  search_at(0.02);
  EXPECT_EQ(live_.counts().searches, searches + 1);
}

// Until its pair is ready a body pushes nothing, and that is said; its tree is built beside the servo.
TEST_F(LiveSceneTest, ABodyWaitsUntilItIsReady) {
  const Pose pose = motion(1)[0];
  const BodyId tool = add(live_, tool_, BodyKind::kTool, pose);
  ASSERT_NE(tool, 0u);
  ASSERT_TRUE(live_.go_live());
  EXPECT_EQ(tick(live_).status, 0u);
  const auto fresh = asset_model("organic_2200");
  const BodyId body = add(live_, fresh, BodyKind::kStatic, {});
  for (int i = 0; i < 3; ++i) {
    const Contacts waiting = tick(live_);
    EXPECT_EQ(waiting.status, kStatusWaiting);
    EXPECT_EQ(waiting.set_count, 0u);
    EXPECT_EQ(fresh->tree_if_built(), nullptr);
  }
  EXPECT_TRUE(live_.search_globally());
  const Contacts ready = tick(live_);
  EXPECT_EQ(ready.status, 0u);
  EXPECT_GT(ready.set_count, 0u);
  EXPECT_EQ(ready.lmds[0].body_a, body);
  EXPECT_EQ(live_.counts().waiting_ticks, 3u);
  EXPECT_EQ(live_.counts().preparations, 1u);
}

// A pair is made ready while it is still farther apart than the cutoff.
TEST_F(LiveSceneTest, WhatComesNearIsReadyBefore) {
  const double far = 3.0 * (body_->radius() + tool_->radius());
  fill(at(far, 0, 0));
  ASSERT_TRUE(live_.go_live());
  EXPECT_EQ(body_->tree_if_built(), nullptr) << "nobody came near";
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(live_.set_pose(tool_id_, at(far - 0.005 * i * far, 0, 0)));
    EXPECT_EQ(tick(live_).status & (kStatusWaiting | kStatusCut), 0u) << "tick " << i;
    live_.search_globally();
  }
  EXPECT_GE(live_.counts().preparations, 1u);
}

TEST_F(LiveSceneTest, FarPairsGiveTheirMemoryBack) {
  fill(motion(1)[0]);
  ASSERT_TRUE(live_.go_live());
  EXPECT_GT(tick(live_).set_count, 0u);
  ASSERT_TRUE(live_.set_pose(tool_id_, at(100, 0, 0)));
  for (int i = 0; i < 1120; ++i) {
    if (i % 100 == 0) tick(live_);
    live_.search_globally();
  }
  ASSERT_TRUE(live_.set_pose(tool_id_, motion(1)[0]));
  tick(live_);
  EXPECT_EQ(tick(live_).status, kStatusWaiting);
  live_.search_globally();
  EXPECT_GT(tick(live_).set_count, 0u);
}

TEST_F(LiveSceneTest, IdsOfRemovedBodiesStayInvalid) {
  const Pose pose = motion(1)[0];
  fill(pose);
  ASSERT_TRUE(live_.go_live());
  std::vector<BodyId> ids;
  for (int round = 0; round < 200; ++round) {
    const BodyId id = add(live_, body_, BodyKind::kMoving, at(0, 10.0 + round, 0));
    ASSERT_TRUE(live_.set_pose(id, at(0, 20, 0)));
    ASSERT_TRUE(live_.pose_of(id).has_value());
    if (round % 3 == 0) tick(live_);
    ids.push_back(id);
    if (round % 2 == 0) {
      EXPECT_TRUE(live_.remove(id));
      EXPECT_FALSE(live_.remove(id));
      EXPECT_FALSE(live_.set_pose(id, pose));
      EXPECT_FALSE(live_.pose_of(id).has_value());
    }
    live_.search_globally();
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end()) << "no id twice";
  const Contacts found = tick(live_);
  EXPECT_EQ(found.work.bodies, 101u) << "one that stands and every other added";
  live_.go_still();
  ASSERT_TRUE(live_.step());
  EXPECT_EQ(newest(live_).work.bodies, 101u);
}

TEST_F(LiveSceneTest, AnotherToolIsMadeReadyAnew) {
  fill(motion(1)[0]);
  ASSERT_TRUE(live_.go_live());
  EXPECT_GT(tick(live_).set_count, 0u);
  EXPECT_FALSE(live_.add({BodyKind::kTool, tool_, {}, 0.0, {}}).ok()) << "a second tool";
  ASSERT_TRUE(live_.remove(tool_id_));
  EXPECT_EQ(tick(live_).set_count, 0u);
  add(live_, asset_model("icosphere"), BodyKind::kTool, motion(1)[0]);
  EXPECT_EQ(tick(live_).status, kStatusWaiting);
  live_.search_globally();
  EXPECT_EQ(tick(live_).status, 0u);
}

TEST_F(LiveSceneTest, OneOfManyPosesWaitsAndItIsTheNewest) {
  const std::vector<Pose> poses = motion(100);
  fill(poses[0]);
  ASSERT_TRUE(live_.go_live());
  tick(live_);
  for (const Pose& pose : poses) ASSERT_TRUE(live_.set_pose(tool_id_, pose));
  ASSERT_TRUE(still_.set_pose(tool_id_, poses.back()));
  ASSERT_TRUE(still_.step());
  EXPECT_TRUE(same(tick(live_), newest(still_)));
}

// More changes than a tick carries out: the rest follows, in order.
TEST_F(LiveSceneTest, AFloodOfChangesIsSpreadOverTicks) {
  fill(motion(1)[0]);
  ASSERT_TRUE(live_.go_live());
  constexpr int kFlood = 1000;
  for (int i = 0; i < kFlood; ++i) add(live_, body_, BodyKind::kStatic, at(50.0 + i, 0, 0));
  const std::uint64_t after_one = tick(live_).work.bodies;
  EXPECT_GT(after_one, 1u);
  EXPECT_LT(after_one, kFlood / 2 + 0u);
  for (int i = 0; i < 5; ++i) tick(live_);
  EXPECT_EQ(tick(live_).work.bodies, kFlood + 1u);
}

// What the list has no room for still pushes.
TEST(LiveSceneRoom, CutsTheListButNotTheWrench) {
  const auto plate = asset_model("box", 40.0), small = asset_model("box", 0.5);
  const DVec3 half = 0.5 * (plate->bounds().high - plate->bounds().low);
  const DVec3 small_half = 0.5 * (small->bounds().high - small->bounds().low);
  const double cutoff = 0.1 * small_half.z, step = 3.0 * std::max(small_half.x, small_half.y);
  LiveScene live({.cutoff = cutoff}), still({.cutoff = cutoff});
  for (LiveScene* scene : {&live, &still}) {
    const DVec3 centre = 0.5 * (plate->bounds().high + plate->bounds().low);
    add(*scene, plate, BodyKind::kTool, at(-centre.x, -centre.y, -centre.z));
    const int side = 18;
    for (int i = 0; i < side * side; ++i)
      add(*scene, small, BodyKind::kStatic,
          at(step * (i % side - side / 2), step * (i / side - side / 2),
             half.z + small_half.z + 0.4 * cutoff));
  }
  ASSERT_LT(step * 10, std::min(half.x, half.y)) << "all lie on the plate";
  ASSERT_TRUE(live.go_live());
  const Contacts found = tick(live);
  ASSERT_TRUE(still.step());
  const Contacts all = newest(still);
  ASSERT_GT(all.lmds.size(), kMostListed.lmds);
  EXPECT_EQ(all.status, 0u);
  EXPECT_EQ(found.status, kStatusCut);
  EXPECT_LE(found.lmds.size(), kMostListed.lmds);
  EXPECT_GT(found.lmds.size(), kMostListed.lmds - 16);
  EXPECT_EQ(found.set_count, all.set_count);
  EXPECT_EQ(found.wrench.force, all.wrench.force);
  EXPECT_EQ(found.wrench.torque, all.wrench.torque);
  double weight = 0.0;
  for (const Contact& contact : found.lmds) weight += contact.weight;
  EXPECT_NEAR(weight, found.lmds.back().set + 1.0, 1e-9) << "no set is listed in part";
  EXPECT_EQ(live.counts().cut_ticks, 1u);
}

// A front that outgrows what it was given gets more from the global search.
TEST(LiveSceneRoom, GrowsBesideTheServo) {
  const auto body = asset_model("spring_23k"), tool = asset_model("teapot_5600");
  const double cutoff = 0.05 * body->bounds().diagonal();
  Random random(3);
  const Pose near = place_near(*body, *tool, 0.1 * cutoff, random);
  LiveScene live({.cutoff = cutoff}), still({.cutoff = cutoff});
  Pose pose = near;
  pose.translation *= 40.0;
  BodyId id = 0;
  for (LiveScene* scene : {&live, &still}) {
    add(*scene, body, BodyKind::kStatic, {});
    id = add(*scene, tool, BodyKind::kTool, pose);
  }
  ASSERT_TRUE(live.go_live());
  tick(live);
  // At once from afar, so that nothing was ready: it waits, then it is right, and ready for what is near.
  ASSERT_TRUE(live.set_pose(id, near));
  ASSERT_TRUE(still.set_pose(id, near));
  EXPECT_EQ(tick(live).status, kStatusWaiting);
  live.search_globally();
  ASSERT_TRUE(still.step());
  const Contacts found = tick(live);
  EXPECT_EQ(found.status, 0u);
  EXPECT_TRUE(same(found, newest(still)));
  // A larger cutoff needs a larger front than was ready.
  live.set_cutoff(10.0 * cutoff);
  still.set_cutoff(10.0 * cutoff);
  ASSERT_TRUE(still.step());
  const Contacts all = newest(still);
  Contacts grown = tick(live);
  EXPECT_EQ(grown.status, kStatusCut);
  EXPECT_GE(grown.set_count, found.set_count) << "those known before push on";
  for (int i = 0; i < 3 && grown.status != 0; ++i) {
    live.search_globally();
    grown = tick(live);
  }
  EXPECT_EQ(grown.status, 0u);
  EXPECT_TRUE(same(grown, all));
}

}  // namespace
}  // namespace palpate
