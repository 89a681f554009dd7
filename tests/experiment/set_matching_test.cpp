#include "samples/cli/set_matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace palpate::cli {
namespace {

using Sets = std::vector<std::vector<int>>;  // each of places

// Sets of points on a line, a metre from each other; both points of an LMD are at one place.
class Outcome {
 public:
  explicit Outcome(const Sets& sets) {
    for (std::size_t set = 0; set < sets.size(); ++set)
      for (const int place : sets[set]) add(static_cast<std::uint32_t>(set), place);
    contacts_.lmds = lmds_.data();
    contacts_.lmd_count = lmds_.size();
    contacts_.lmd_stride = sizeof(plp_lmd);
    contacts_.set_count = sets.size();
  }
  Outcome(const Outcome&) = delete;

  const plp_contacts& contacts() const { return contacts_; }

 private:
  void add(std::uint32_t set, int place) {
    plp_lmd lmd{};
    lmd.point_a[0] = lmd.point_b[0] = place;
    lmd.set = set;
    lmds_.push_back(lmd);
  }

  std::vector<plp_lmd> lmds_;
  plp_contacts contacts_{};
};

std::size_t pairs(const Sets& one, const Sets& other) {
  const Outcome a(one), b(other);
  return SetMatching(a.contacts(), b.contacts(), 1e-9).pairs();
}

TEST(SetMatching, TwoSetsAtOnePlaceAreNotOne) {
  EXPECT_EQ(pairs({{1}, {1}}, {{1}}), 1u);
  EXPECT_EQ(pairs({{1}}, {{1}, {1}}), 1u);
  EXPECT_EQ(pairs({{1}, {1}}, {{1}, {1}}), 2u);
}

TEST(SetMatching, APlateauMayBeRepresentedByOthersOfItsPoints) {
  EXPECT_EQ(pairs({{1, 2, 3}}, {{3, 4}}), 1u);
  EXPECT_EQ(pairs({{1, 2}}, {{3, 4}}), 0u);
}

TEST(SetMatching, BothPointsDecide) {
  const Outcome one(Sets{{1}}), other(Sets{{1}});
  plp_lmd away = other.contacts().lmds[0];
  away.point_b[1] = 0.5;
  plp_contacts moved = other.contacts();
  moved.lmds = &away;
  EXPECT_EQ(SetMatching(one.contacts(), moved, 1e-9).pairs(), 0u);
  EXPECT_EQ(SetMatching(one.contacts(), moved, 0.5).pairs(), 1u);
}

TEST(SetMatching, GivesUpAPartnerThatAnotherNeeds) {
  EXPECT_EQ(pairs({{1, 2}, {1}}, {{1}, {2}}), 2u);
  EXPECT_EQ(pairs({{1, 2}, {2, 3}, {1}}, {{1}, {2}, {3}}), 3u);
}

TEST(SetMatching, OfNothingIsNothing) {
  EXPECT_EQ(pairs({}, {}), 0u);
  EXPECT_EQ(pairs({{1}}, {}), 0u);
}

// The most pairs that any order of partners gives.
std::size_t most_pairs(const Sets& one, const Sets& other) {
  std::vector<std::size_t> order(std::max(one.size(), other.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto alike = [](const std::vector<int>& a, const std::vector<int>& b) {
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
  };
  std::size_t most = 0;
  do {
    std::size_t count = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
      count += order[i] < other.size() && alike(one[i], other[order[i]]);
    most = std::max(most, count);
  } while (std::next_permutation(order.begin(), order.end()));
  return most;
}

TEST(SetMatching, IsTheLargest) {
  constexpr unsigned kSeed = 5;
  std::mt19937 random(kSeed);
  const auto sets = [&] {
    Sets made(random() % 6);
    for (std::vector<int>& set : made)
      for (unsigned i = 0; i <= random() % 3; ++i) set.push_back(static_cast<int>(random() % 8));
    return made;
  };
  for (int i = 0; i < 500; ++i) {
    const auto one = sets(), other = sets();
    ASSERT_EQ(pairs(one, other), most_pairs(one, other)) << "seed " << kSeed << " case " << i;
  }
}

}  // namespace
}  // namespace palpate::cli
