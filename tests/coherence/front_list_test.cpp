// Lists of pairs of nodes: what the wide scans find, against a plain list.
#include "engine/snch/front_list.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <vector>

#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 23;
constexpr std::uint32_t kNodes = 1000;

struct Entry {
  NodePair nodes;
  Until until;
};

class FrontLists : public testing::Test {
 protected:
  ~FrontLists() override { hwy::SetSupportedTargetsForTest(0); }

  void add() {
    const Entry entry{random_pair(), {random_reading(), random_reading()}};
    plain_.push_back(entry);
    list_.add(entry.nodes, entry.until);
  }
  void remove() {
    const std::size_t i = random_.below(plain_.size());
    plain_[i] = plain_.back();
    plain_.pop_back();
    list_.remove(i);
  }

  NodePair random_pair() {
    NodePair pair{random_node(), random_node()};
    const auto place = static_cast<std::uint8_t>(random_.below(10));
    if (place <= TrianglePlace::kFace) pair.a = FeatureNode::code_of(pair.a, {place});
    return pair;
  }
  std::uint32_t random_node() { return static_cast<std::uint32_t>(random_.below(kNodes)); }
  float random_reading() { return static_cast<float>(random_.below(20)); }  // often the same
  FrontCell random_cell() {
    const NodePair root{random_node(), random_node()};
    return {root, root.a + 1 + random_node(), root.b + 1 + random_node()};
  }

  template <class Condition>
  std::vector<std::uint32_t> indices_where(const Condition& condition) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < plain_.size(); ++i)
      if (condition(plain_[i])) found.push_back(i);
    return found;
  }

  void expect_same_scans() {
    const Until now{random_reading(), random_reading()};
    std::vector<std::uint32_t> found;
    list_.find_passed(now, found);
    ASSERT_EQ(found, indices_where([&](const Entry& entry) { return entry.until.has_passed(now); }));
    const FrontCell cell = random_cell();
    const auto held = indices_where([&](const Entry& entry) {
      return cell.holds({FeatureNode(entry.nodes.a).node(), FeatureNode(entry.nodes.b).node()});
    });
    list_.find_held(cell, found);
    ASSERT_EQ(found, held);
    ASSERT_EQ(list_.count_held(cell), held.size());
  }

  std::vector<Entry> plain_;
  FrontList list_;
  Random random_{kSeed};
};

TEST_F(FrontLists, FindWhatAPlainListDoes) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    for (int round = 0; round < 300; ++round) {
      for (std::size_t i = random_.below(40); i > 0; --i) add();
      for (std::size_t i = random_.below(35); i > 0 && !plain_.empty(); --i) remove();
      ASSERT_EQ(list_.size(), plain_.size());
      SCOPED_TRACE(testing::Message() << hwy::TargetName(target) << " seed " << kSeed << " round " << round);
      expect_same_scans();
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(plain_.size(), 3 * FrontList::kBlock);
}

TEST_F(FrontLists, HoldNothingWhenCleared) {
  for (int i = 0; i < 100; ++i) add();
  list_.clear();
  plain_.clear();
  expect_same_scans();
  add();
  expect_same_scans();
}

TEST_F(FrontLists, AllocateNothingWithinTheirRoom) {
  list_.reserve(1000);
  const std::size_t room = list_.capacity();
  EXPECT_GE(room, 1000u);
  for (std::size_t i = 0; i < room; ++i) add();
  EXPECT_EQ(list_.capacity(), room);
}

}  // namespace
}  // namespace palpate
