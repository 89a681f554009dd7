#include "tests/stress/triangle_stress.h"

#include <algorithm>
#include <cmath>

#include "engine/kernel/triangle_batch.h"
#include "engine/kernel/triangle_pair.h"
#include "engine/mesh/placement.h"
#include "tests/stress/exact_triangles.h"
#include "tests/stress/peers.h"
#include "tests/support/models.h"

namespace palpate::stress {
namespace {

constexpr int kNearPairs = 12;
constexpr int kAnyPairs = 4;
constexpr double kWrong = 1e-6;
constexpr double kSurelyApart = 1e-9;  // of the size

// The same two triangles as every method has them.
struct Pair {
  Triangle normalised_a, normalised_b;  // Palpate: A's normalised frame
  Triangle metres_a, metres_b;          // others: A's frame, in double precision
  ExactTriangle exact_a, exact_b;       // metres
};

class Pairs {
 public:
  Pairs(const Mesh& a, const Mesh& b, const Pose& pose)
      : a_(a), b_(b), pose_(pose), placement_(a.frame, b.frame, pose) {}

  double between(std::uint32_t in_a, std::uint32_t in_b) const {
    const Triangle one = triangle_of(a_, in_a), other = triangle_of(b_, in_b, placement_);
    return closest_points(one, other).squared_distance;
  }

  Pair at(std::uint32_t in_a, std::uint32_t in_b) const {
    Pair pair{triangle_of(a_, in_a), triangle_of(b_, in_b, placement_), {}, {}, {}, {}};
    for (int k = 0; k < 3; ++k) {
      const Vec3 &p = a_.positions[a_.triangles[in_a][k]], &q = b_.positions[b_.triangles[in_b][k]];
      pair.metres_a.corner[k] = a_.frame.metres(DVec3(p));
      pair.metres_b.corner[k] = pose_ * b_.frame.metres(DVec3(q));
      pair.exact_a.corner[k] = RVec3(a_.frame.origin) + RVec3(p) * a_.frame.scale;
      const RVec3 own = RVec3(b_.frame.origin) + RVec3(q) * b_.frame.scale;
      pair.exact_b.corner[k] = RVec3(pose_.rotation[0]) * own.x + RVec3(pose_.rotation[1]) * own.y +
                               RVec3(pose_.rotation[2]) * own.z + RVec3(pose_.translation);
    }
    return pair;
  }

  double scale() const { return a_.frame.scale; }
  double touch() const { return touching_distance(placement_); }

 private:
  const Mesh& a_;
  const Mesh& b_;
  const Pose pose_;
  const Placement placement_;
};

// `rounding`: of the pose itself, which no method can make good.
void count(TriangleTally& tally, double distance, double exact, double size, double rounding) {
  if (distance < 0) return;
  ++tally.pairs;
  const double error = std::abs(distance - exact) / size;
  tally.errors.push_back(std::isfinite(error) ? error : HUGE_VAL);
  tally.wrong += !(error <= kWrong);
  tally.false_contacts += distance == 0 && exact > kSurelyApart * size + rounding;
  tally.false_gaps += exact == 0 && distance > kSurelyApart * size + rounding;
}

double palpate_distance(const Pair& pair, double touch) {
  const ClosestPoints closest = closest_points(pair.normalised_a, pair.normalised_b);
  if (triangles_touch(pair.normalised_a, pair.normalised_b, closest, touch)) return 0.0;
  return std::sqrt(closest.squared_distance);
}

// What the wide kernel says the distance is not less than.
double bound_of(const Pair& pair) {
  TriangleBatch batch{};
  const DVec3 origin = pair.normalised_a.corner[0];
  batch.first.set(0, pair.normalised_a, origin);
  batch.second.set(0, pair.normalised_b, origin);
  TriangleBatch::Closest closest;
  batch.measure(1, closest);
  return closest.least_distance[0];
}

double size_of(const DVec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

}  // namespace

void TriangleTally::add(const TriangleTally& other) {
  pairs += other.pairs;
  wrong += other.wrong;
  false_contacts += other.false_contacts;
  false_gaps += other.false_gaps;
  errors.insert(errors.end(), other.errors.begin(), other.errors.end());
}

void TriangleOutcome::add(const TriangleOutcome& other) {
  palpate.add(other.palpate);
  fcl.add(other.fcl);
  fcl_single.add(other.fcl_single);
  unsafe_bounds += other.unsafe_bounds;
}

TriangleOutcome stress_triangles(const Case& c, Random& random) {
  const auto a = make_model(c.a), b = make_model(c.b);
  const Pairs pairs(a->mesh(), b->mesh(), c.a_from_b);
  struct Choice {
    double between;
    std::uint32_t a, b;
  };
  std::vector<Choice> choices;
  for (std::uint32_t in_a = 0; in_a < a->mesh().triangles.size(); ++in_a)
    for (std::uint32_t in_b = 0; in_b < b->mesh().triangles.size(); ++in_b)
      choices.push_back({pairs.between(in_a, in_b), in_a, in_b});
  std::sort(choices.begin(), choices.end(), [](const Choice& x, const Choice& y) {
    return std::tie(x.between, x.a, x.b) < std::tie(y.between, y.a, y.b);
  });
  if (choices.size() > kNearPairs) {
    for (int i = 0; i < kAnyPairs; ++i) choices[kNearPairs - 1 - i] = choices[random.below(choices.size())];
    choices.resize(kNearPairs);
  }
  const double rounding = 4.5e-16 * (size_of(c.a_from_b.translation) + size_of(a->mesh().frame.origin) +
                                     size_of(b->mesh().frame.origin));
  TriangleOutcome outcome;
  for (const Choice& choice : choices) {
    const Pair pair = pairs.at(choice.a, choice.b);
    const auto exact = static_cast<double>(exact_closest(pair.exact_a, pair.exact_b).distance);
    const auto size = static_cast<double>(std::min(pair.exact_a.longest_side(), pair.exact_b.longest_side()));
    count(outcome.palpate, palpate_distance(pair, pairs.touch()) * pairs.scale(), exact, size, rounding);
    count(outcome.fcl, fcl_distance(pair.metres_a, pair.metres_b), exact, size, rounding);
    count(outcome.fcl_single, fcl_distance_in_single(pair.metres_a, pair.metres_b), exact, size, rounding);
    outcome.unsafe_bounds += exact > 0 && bound_of(pair) * pairs.scale() > exact + rounding;
  }
  return outcome;
}

}  // namespace palpate::stress
