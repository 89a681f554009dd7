// Searches whose memory is fixed: what finds no room is said, and what is said is true.
#include <algorithm>

#include <gtest/gtest.h>

#include "engine/scene/pair_search.h"
#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

// Counts wishes; gives complete sets that a test puts in.
class FakeService : public SearchService {
 public:
  const Searched* newest() override { return std::exchange(fresh_, false) ? &searched_ : nullptr; }
  void want_room() override { ++wishes; }

  Searched& put() {
    fresh_ = true;
    return searched_;
  }
  int wishes = 0;

 private:
  bool fresh_ = false;
  Searched searched_;
};

bool holds(const LmdSet& complete, const Lmd& lmd) {
  return std::any_of(complete.lmds.begin(), complete.lmds.end(), [&](const Lmd& other) {
    return other.feature_a == lmd.feature_a && other.feature_b == lmd.feature_b &&
           std::abs(other.distance - lmd.distance) < 1e-12;
  });
}

class FixedSearch : public testing::Test {
 protected:
  FixedSearch() {
    Random random(kSeed);
    situation_.cutoff = 0.02 * a_->bounds().diagonal();
    situation_.max_overlaps = 64;
    situation_.mode = SearchMode::kCertified;
    motion_ = sliding_motion(*a_, *b_, situation_.cutoff, 0.2 * a_->bounds().diagonal(), 120, random);
  }

  void move(PairSearch& pair, const Pose& pose) {
    situation_.body_from_tool = pose;
    ++situation_.step;
    pair.update(*a_, *b_, situation_, search_);
  }
  const LmdSet& complete_at(const Pose& pose) {
    SearchOptions options;
    options.cutoff = situation_.cutoff;
    search_.run(*a_, *b_, pose, options, complete_);
    return complete_;
  }

  static constexpr std::uint64_t kSeed = 11;
  const std::shared_ptr<const Model> a_ = asset_model("organic_2200");
  const std::shared_ptr<const Model> b_ = asset_model("torus");
  std::shared_ptr<FakeService> service_ = std::make_shared<FakeService>();
  std::vector<Pose> motion_;
  PairSituation situation_;
  LmdSearch search_;
  LmdSet complete_;
};

TEST_F(FixedSearch, WithRoomFindsTheSame) {
  PairSearch pair;
  move(pair, motion_[0]);
  pair.fix({}, service_, false);
  for (const Pose& pose : motion_) {
    move(pair, pose);
    EXPECT_FALSE(pair.found().cut);
    EXPECT_EQ(pair.found().lmds.size(), complete_at(pose).lmds.size());
  }
  EXPECT_EQ(service_->wishes, 0);
}

TEST_F(FixedSearch, WithoutRoomFollowsWhatItKnowsAndAsksForMore) {
  PairSearch pair;
  situation_.mode = SearchMode::kDescent;  // so that minima are known, but no front
  move(pair, motion_[0]);
  pair.fix({.front = 600, .minima = 600, .overlaps = 64}, service_, false);
  situation_.mode = SearchMode::kCertified;
  std::size_t found = 0, complete = 0;
  for (const Pose& pose : motion_) {
    move(pair, pose);
    EXPECT_TRUE(pair.found().cut) << "it says so until it has more room";
    const LmdSet& all = complete_at(pose);
    for (const Lmd& lmd : pair.found().lmds) EXPECT_TRUE(holds(all, lmd));
    found += pair.found().set_count;
    complete += all.set_count;
  }
  EXPECT_GT(found, complete * 7 / 10);
  EXPECT_GT(service_->wishes, 0);

  PairSearch prepared;
  const Pose& before = motion_[motion_.size() - 2];
  move(prepared, before);
  prepared.fix({}, std::make_shared<FakeService>(), false);
  pair.take(prepared);
  EXPECT_TRUE(pair.ready());
  move(pair, motion_.back());
  EXPECT_TRUE(pair.searched());
  EXPECT_FALSE(pair.found().cut);
  EXPECT_EQ(pair.found().lmds.size(), complete_at(motion_.back()).lmds.size());
  EXPECT_LT(pair.work().front_expired, pair.work().front_entries / 2) << "the prepared front was used";
}

// The front is lost while LMDs are followed: they go on pushing.
TEST(FixedSearchAlone, GoesOnPushingWhenAFrontIsLost) {
  const auto model = asset_model("voxels");
  const double diagonal = model->bounds().diagonal();
  Random random(3);
  PairSituation situation;
  situation.body_from_tool = place_near(*model, *model, 0.005 * diagonal, random);
  situation.cutoff = 0.05 * diagonal;
  situation.max_overlaps = 64;
  situation.mode = SearchMode::kCertified;
  LmdSearch search;
  PairSearch pair;
  pair.update(*model, *model, situation, search);
  const std::uint32_t known = pair.found().set_count;
  ASSERT_GT(known, 1u);
  pair.fix({.front = 1, .minima = 300, .overlaps = 64}, std::make_shared<FakeService>(), false);
  situation.cutoff *= 10.0;
  pair.update(*model, *model, situation, search);
  EXPECT_TRUE(pair.found().cut) << "four times what was used is not enough for this cutoff";
  EXPECT_EQ(pair.found().set_count, known);
}

TEST_F(FixedSearch, DescendsFromTheSetsOfItsService) {
  situation_.mode = SearchMode::kDescent;
  PairSearch pair;
  move(pair, motion_[0]);
  pair.fix({}, service_, false);
  std::size_t found = 0, complete = 0;
  for (std::size_t i = 0; i < motion_.size(); ++i) {
    if (i % 8 == 3) {
      SearchService::Searched& searched = service_->put();
      searched.found = complete_at(motion_[i - 1]);
      searched.radius = 1.2 * situation_.cutoff;
      searched.step = situation_.step;
      searched.search_us = 12.0;
    }
    move(pair, motion_[i]);
    if (i >= 3) {
      EXPECT_EQ(pair.work().age, 1 + (i - 3) % 8);
      EXPECT_EQ(pair.work().global_us, i % 8 == 3 ? 12.0 : 0.0);
    }
    const LmdSet& all = complete_at(motion_[i]);
    for (const Lmd& lmd : pair.found().lmds) EXPECT_TRUE(holds(all, lmd)) << "tick " << i;
    found += pair.found().set_count;
    complete += all.set_count;
  }
  EXPECT_GT(found, complete * 8 / 10);
  EXPECT_FALSE(pair.found().cut);
}

}  // namespace
}  // namespace palpate
