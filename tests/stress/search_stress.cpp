#include "tests/stress/search_stress.h"

#include <cmath>

#include "engine/descent/polar_descent.h"
#include "engine/scene/pair_search.h"
#include "tests/support/models.h"

namespace palpate::stress {
namespace {

constexpr std::uint32_t kMostTicks = 40;  // poses before the last
constexpr int kMostTries = 256;           // a descent is cut short after 64 steps; all together it must end
constexpr int kDescents = 8;              // from pairs of triangles at random, at each case's pose
constexpr double kTolerance = 1e-6;
constexpr double kTolerancePlateau = 4e-6;  // after one

// About the distance of the farthest corner from the origin, about which it turns.
double size_of(const TriangleSoup& soup) {
  double size = 0.0;
  for (const DVec3& position : soup.positions) size = std::max(size, glm::length(position));
  return size;
}

// A straight way to the case's pose while turning, slow or fast.
std::vector<Pose> motion_to(const Case& c, Random& random) {
  const std::uint32_t ticks = 4 + random.below(kMostTicks);
  const double tick = c.step * std::pow(10.0, random.uniform(-3.0, 0.0));
  const DVec3 along = random.direction() * tick, about = random.direction();
  const double turn = std::min(tick / size_of(c.b), 1.0) * random.uniform(0.0, 2.0);
  std::vector<Pose> motion;
  for (std::uint32_t left = ticks; left > 0; --left) {
    const DMat3 rotation = glm::mat3_cast(glm::angleAxis(turn * left, about));
    motion.push_back({rotation * c.a_from_b.rotation, c.a_from_b.translation + along * double(left)});
  }
  motion.push_back(c.a_from_b);
  return motion;
}

void follow(const Model& a, const Model& b, const Case& c, const std::vector<Pose>& motion, SearchMode mode,
            const Reference& last, Verdict& verdict) {
  PairSearch pair;
  LmdSearch search;
  PairSituation situation;
  situation.cutoff = c.cutoff;
  situation.max_overlaps = 16;
  situation.mode = mode;
  for (const Pose& pose : motion) {
    situation.body_from_tool = pose;
    ++situation.step;
    pair.update(a, b, situation, search);
  }
  verdict.add(last.judge(pair.found(), kTolerancePlateau, mode == SearchMode::kCertified));
}

void descend(const Model& a, const Model& b, const Pose& pose, Random& random, SearchOutcome& outcome) {
  const Placement placement(a.mesh().frame, b.mesh().frame, pose);
  const DescentPair pair(a.mesh(), b.mesh(), placement);
  for (int i = 0; i < kDescents; ++i) {
    DescentWork work;
    DescentPoint point = pair.measure(
        {random.below(a.mesh().triangles.size()), random.below(b.mesh().triangles.size())}, work);
    int tries = 0;
    while (!PolarDescent().descend(pair, point, work) && ++tries < kMostTries) {
    }
    outcome.cut_short += tries > 0;
    outcome.endless += tries == kMostTries;
    outcome.most_steps = std::max(outcome.most_steps, static_cast<int>(work.steps));
    ++outcome.descents;
  }
}

}  // namespace

void SearchOutcome::add(const SearchOutcome& other) {
  cases += other.cases;
  poses += other.poses;
  global.add(other.global);
  certified.add(other.certified);
  descent.add(other.descent);
  most_steps = std::max(most_steps, other.most_steps);
  cut_short += other.cut_short;
  endless += other.endless;
  descents += other.descents;
}

int SearchOutcome::faults() const {
  int count = endless;
  for (const Verdict* verdict : {&global, &certified, &descent})
    count += verdict->missed + verdict->spurious + verdict->wrong_overlap + verdict->not_numbers;
  return count;
}

SearchOutcome stress_search(const Case& c, Random& random) {
  const auto a = make_model(c.a), b = make_model(c.b);
  const Reference reference(a->mesh(), b->mesh(), c.a_from_b, c.cutoff);
  SearchOutcome outcome;
  outcome.cases = 1;
  LmdSearch search;
  LmdSet found;
  SearchOptions options;
  options.cutoff = c.cutoff;
  search.run(*a, *b, c.a_from_b, options, found);
  outcome.global = reference.judge(found, kTolerance, true);
  const std::vector<Pose> motion = motion_to(c, random);
  outcome.poses = 1 + static_cast<int>(motion.size());
  follow(*a, *b, c, motion, SearchMode::kCertified, reference, outcome.certified);
  follow(*a, *b, c, motion, SearchMode::kDescent, reference, outcome.descent);
  descend(*a, *b, c.a_from_b, random, outcome);
  return outcome;
}

}  // namespace palpate::stress
