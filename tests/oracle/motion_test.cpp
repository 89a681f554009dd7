// What a scene finds between a body and the tool while a hand moves it, against brute force: in certified
// ticks all that the definition asks for and nothing else, in descent nothing else.
#include <gtest/gtest.h>

#include <cstdio>

#include "engine/scene/pair_search.h"
#include "tests/oracle/oracle.h"
#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 1905;
constexpr double kDiagonal = 0.3;  // metres, of both models
constexpr double kCutoff = 0.006;
constexpr double kSpeed = 0.3;  // metres a second
constexpr int kChecks = 20;     // ticks of each motion that are checked

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kTicks = 40;
#else
constexpr int kTicks = 400;
#endif

struct Pair {
  const char* a;
  const char* b;
  bool from_data;
};

void PrintTo(const Pair& pair, std::ostream* out) {
  *out << pair.a << " - " << pair.b;
}

std::shared_ptr<const Model> model_of(const char* name, bool from_data) {
  const auto scaled_by = [&](double scale) {
    return from_data ? data_model(name, scale) : asset_model(name, scale);
  };
  return scaled_by(kDiagonal / scaled_by(1.0)->bounds().diagonal());
}

// One after another the outcomes of one mode along a motion.
class Follower {
 public:
  Follower(const Model& a, const Model& b, SearchMode mode) : a_(a), b_(b) {
    situation_.cutoff = kCutoff;
    situation_.max_overlaps = 16;
    situation_.mode = mode;
  }

  const LmdSet& at(const Pose& pose) {
    situation_.body_from_tool = pose;
    ++situation_.step;
    pair_.update(a_, b_, situation_, search_);
    return pair_.found();
  }

 private:
  const Model& a_;
  const Model& b_;
  PairSituation situation_;
  PairSearch pair_;
  LmdSearch search_;
};

// LMDs of different sets at one place.
int found_twice(const LmdSet& found) {
  constexpr double kOnePlace = 1e-9 * kDiagonal;
  int count = 0;
  for (std::size_t i = 0; i < found.lmds.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      count += found.lmds[i].set != found.lmds[k].set &&
               glm::length(found.lmds[i].point_a - found.lmds[k].point_a) < kOnePlace &&
               glm::length(found.lmds[i].point_b - found.lmds[k].point_b) < kOnePlace;
  return count;
}

class Motion : public testing::TestWithParam<Pair> {};

TEST_P(Motion, FindsWhatTheDefinitionSays) {
  const Pair& pair = GetParam();
  if (pair.from_data && !data_folder()) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const auto a = model_of(pair.a, pair.from_data), b = model_of(pair.b, pair.from_data);
  const oracle::Surface surface_a(a->mesh()), surface_b(b->mesh());
  const oracle::Oracle oracle(surface_a, surface_b);
  Random random(kSeed);
  const std::vector<Pose> motion = sliding_motion(*a, *b, kCutoff, kSpeed, kTicks, random);
  Follower certified(*a, *b, SearchMode::kCertified), descent(*a, *b, SearchMode::kDescent);
  std::size_t certain = 0, certified_sets = 0, descent_sets = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    const Pose& pose = motion[static_cast<std::size_t>(tick)];
    const LmdSet &complete = certified.at(pose), &followed = descent.at(pose);
    EXPECT_EQ(found_twice(complete) + found_twice(followed), 0) << "seed " << kSeed << " tick " << tick;
    if ((tick + 1) % (kTicks / kChecks) != 0) continue;
    const oracle::Truth truth = oracle.search(pose, kCutoff);
    const auto of_certified = oracle.compare(complete, truth, pose, kCutoff);
    const auto of_descent = oracle.compare(followed, truth, pose, kCutoff);
    EXPECT_EQ(of_certified.missed + of_certified.spurious + of_certified.wrong_overlap, 0)
        << "seed " << kSeed << " tick " << tick << ": " << of_certified.first;
    EXPECT_EQ(of_descent.spurious, 0) << "seed " << kSeed << " tick " << tick << ": " << of_descent.first;
    certain += truth.certain.size();
    certified_sets += complete.set_count;
    descent_sets += followed.set_count;
  }
  std::printf(
      "%s - %s, seed %llu: of %d ticks %d checked: %zu certain minima, %zu sets certified, %zu by descent\n",
      pair.a, pair.b, static_cast<unsigned long long>(kSeed), kTicks, kChecks, certain, certified_sets,
      descent_sets);
  EXPECT_GE(certain, static_cast<std::size_t>(kChecks / 2)) << "they slide past each other";
}

INSTANTIATE_TEST_SUITE_P(Assets, Motion,
                         testing::Values(Pair{"crankshaft_45k", "gear_6k", false},
                                         Pair{"spring_23k", "teapot_5600", false},
                                         Pair{"organic_97k", "organic_2200", false}));

INSTANTIATE_TEST_SUITE_P(Data, Motion,
                         testing::Values(Pair{"crankshaft_45k.glb", "gear_6k.glb", true},
                                         Pair{"spring_23k.glb", "teapot_5600.glb", true},
                                         Pair{"horse_outward.glb", "bunny_2200.glb", true}));

}  // namespace
}  // namespace palpate
