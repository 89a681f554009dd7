#include "engine/descent/lmd_tracker.h"

#include <algorithm>
#include <span>
#include <utility>

namespace palpate {
namespace {

// A plateau is explored over at most this many pairs of triangles; the rest of a larger one adds no extreme
// points beyond what the last search found.
constexpr std::size_t kMaxExplored = 4096;

unsigned corner_bit(TrianglePlace place) {
  return place.is_corner() ? 1u << place.code : 0u;
}

unsigned side_bit(TrianglePlace place) {
  return place.is_side() ? 1u << place.side() : 0u;
}

// One that was found twice. Squared distance is convex on a pair of features, so where a minimum is alone
// there is no other; from another of its triangles it differs by rounding.
bool same_minimum(const Minimum& one, const Minimum& other) {
  const bool same_features = one.feature_a == other.feature_a && one.feature_b == other.feature_b;
  return same_features && (one.alone || other.alone || one.point_b == other.point_b);
}

// Leaves the sets whose first point is within the cutoff, numbered anew.
void drop_sets_beyond(double cutoff, LmdSet& found) {
  std::size_t kept = 0;
  std::uint32_t sets = 0;
  for (std::size_t i = 0, end; i < found.lmds.size(); i = end) {
    for (end = i + 1; end < found.lmds.size() && found.lmds[end].set == found.lmds[i].set;) ++end;
    if (found.lmds[i].distance > cutoff) continue;
    for (std::size_t k = i; k < end; ++k) {
      found.lmds[kept] = found.lmds[k];
      found.lmds[kept++].set = sets;
    }
    ++sets;
  }
  found.lmds.erase(found.lmds.begin() + static_cast<std::ptrdiff_t>(kept), found.lmds.end());
  found.set_count = sets;
}

}  // namespace

// What one call of follow() works with.
struct LmdTracker::Tick {
  const DescentPair& pair;
  FeaturePairTest::Limits limits;
  std::size_t max_overlaps;

  TestedTriangle tested_a(std::uint32_t t, unsigned corners, unsigned sides) const {
    return {t, triangle_of(pair.a(), t), corners, sides};
  }
  TestedTriangle tested_b(std::uint32_t t, unsigned corners, unsigned sides) const {
    return {t, triangle_of(pair.b(), t, pair.placement()), corners, sides};
  }
  TestedTriangle tested_a(std::uint32_t t, TrianglePlace at) const {
    return tested_a(t, corner_bit(at), side_bit(at));
  }
  TestedTriangle tested_b(std::uint32_t t, TrianglePlace at) const {
    return tested_b(t, corner_bit(at), side_bit(at));
  }
};

void LmdTracker::fix(const Room& room) {
  fixed_ = true;
  seeds_.reserve(2 * room.minima);  // those followed, and those of a search
  unfinished_.reserve(seeds_.capacity());
  explored_.reserve(kMaxExplored);
  minima_.reserve(room.minima);
  grouper_.fix(minima_.capacity());
}

void LmdTracker::unfix() {
  fixed_ = false;
  grouper_.fix(0);
}

bool LmdTracker::has_room_for_test() const {
  return !fixed_ || has_room(minima_, FeaturePairTest::kMostFound);
}

void LmdTracker::adopt(const Mesh& a, const Mesh& b, const LmdSet& searched) {
  remember(a, b, searched);
  sort_seeds();
}

void LmdTracker::adopt(std::span<const TrianglePair> seeds) {
  for (const TrianglePair& seed : seeds) add_seed(Seed(seed));
  sort_seeds();
}

void LmdTracker::sort_seeds() {
  std::sort(seeds_.begin(), seeds_.end());
  seeds_.erase(std::unique(seeds_.begin(), seeds_.end()), seeds_.end());
}

void LmdTracker::follow(const Mesh& a, const Mesh& b, const Pose& a_from_b, const SearchOptions& options,
                        double cutoff, LmdSet& found) {
  const Placement placement(a.frame, b.frame, a_from_b);
  const DescentPair pair(a, b, placement);
  const double touch = touching_distance(placement);
  const Tick tick{
      pair, {options.cutoff / a.frame.scale, touch, options.parallel_tolerance}, options.max_overlaps};
  found.clear();
  work_ = {};
  minima_.clear();
  explored_.clear();
  unfinished_.clear();
  FeaturePairTest test(a, b, placement, tick.limits, minima_);
  for (const Seed& seed : seeds_) follow_seed(tick, seed, test, found);

  std::sort(minima_.begin(), minima_.end(), precedes);
  minima_.erase(std::unique(minima_.begin(), minima_.end(), same_minimum), minima_.end());
  grouper_.group(a, b, touch, minima_, found);
  to_metres(a.frame, found);
  found.work.triangle_pairs = work_.triangle_pairs;
  found.cut |= std::exchange(overflowed_, false);
  seeds_.clear();
  remember(a, b, found);
  for (const TrianglePair& pair : unfinished_) add_seed(Seed(pair));
  drop_sets_beyond(cutoff, found);
}

void LmdTracker::remember(const Mesh& a, const Mesh& b, const LmdSet& found) {
  for (const Lmd& lmd : found.lmds) add_seed(Seed(a, b, lmd.feature_a, lmd.feature_b));
}

void LmdTracker::add_seed(const Seed& seed) {
  if (fixed_ && !has_room(seeds_, 1))
    overflowed_ = true;
  else
    seeds_.push_back(seed);
}

void LmdTracker::follow_seed(const Tick& tick, const Seed& seed, FeaturePairTest& test, LmdSet& found) {
  ++work_.descents;
  if (!has_room_for_test()) {
    found.cut = true;
    return;
  }
  if (form_ == DescentForm::kPolar && stands(tick, seed, test)) return;
  DescentPoint point = tick.pair.measure(seed.triangles, work_);
  if (!descend(tick.pair, point)) return unfinished_.push_back(point.triangles);
  const Triangle in_a = triangle_of(tick.pair.a(), point.triangles.a);
  const Triangle in_b = triangle_of(tick.pair.b(), point.triangles.b, tick.pair.placement());
  if (triangles_touch(in_a, in_b, point.closest, tick.limits.touch))
    return found.add_overlap(point.triangles, tick.max_overlaps);
  decide(tick, point, test, found);
}

// Most minima stay on their features. Squared distance is convex on a pair of triangles, so a minimum that is
// alone is the pair's one pair of closest points, no lean leads away from it, and the triangles do not cross:
// a descent by polar cones would end where it began.
bool LmdTracker::stands(const Tick& tick, const Seed& seed, FeaturePairTest& test) {
  const std::size_t before = minima_.size();
  const Seed here = walked(tick.pair, seed);
  ++work_.triangle_pairs;
  test(tick.tested_a(here.triangles.a, here.at_a), tick.tested_b(here.triangles.b, here.at_b),
       FeaturePairSet::of(here.at_a, here.at_b));
  if (alone_since(before)) return true;
  minima_.erase(minima_.begin() + static_cast<std::ptrdiff_t>(before), minima_.end());
  return false;
}

// Where it leads on is tested once more; nothing is lost if it is wrong.
Seed LmdTracker::walked(const DescentPair& pair, const Seed& seed) {
  Feature a = feature_at(pair.a(), seed.triangles.a, seed.at_a),
          b = feature_at(pair.b(), seed.triangles.b, seed.at_b);
  const std::uint64_t steps = work_.steps;
  if (!FeatureWalk(pair).settle(a, b, work_) || work_.steps == steps) return seed;
  return Seed(pair.a(), pair.b(), a, b);
}

bool LmdTracker::alone_since(std::size_t before) const {
  return minima_.size() > before &&
         std::all_of(minima_.begin() + static_cast<std::ptrdiff_t>(before), minima_.end(),
                     [](const Minimum& minimum) { return minimum.alone; });
}

bool LmdTracker::descend(const DescentPair& pair, DescentPoint& point) {
  return form_ == DescentForm::kPolar ? polar_.descend(pair, point, work_)
                                      : neighbourhood_.descend(pair, point, work_);
}

// The features of the closest points decide; all features of the two triangles where those do not, as on
// parallel edges, whose closest points may be anywhere between.
void LmdTracker::decide(const Tick& tick, const DescentPoint& point, FeaturePairTest& test, LmdSet& found) {
  if (!has_room_for_test()) {
    found.cut = true;
    return;
  }
  const Seed here(tick.pair.a(), tick.pair.b(), tick.pair.feature_a(point), tick.pair.feature_b(point));
  const std::size_t before = minima_.size();
  test(tick.tested_a(here.triangles.a, here.at_a), tick.tested_b(here.triangles.b, here.at_b));
  if (!alone_since(before)) explore_plateau(tick, point.triangles, test, found);
}

// Breadth first over the pairs of triangles that share a minimum of the plateau.
void LmdTracker::explore_plateau(const Tick& tick, TrianglePair from, FeaturePairTest& test, LmdSet& found) {
  const auto add = [this](TrianglePair pair) {
    if (explored_.size() < kMaxExplored &&
        std::find(explored_.begin(), explored_.end(), pair) == explored_.end())
      explored_.push_back(pair);
  };
  std::size_t next = explored_.size();
  add(from);
  for (; next < explored_.size(); ++next) {
    if (!has_room_for_test()) {
      found.cut = true;
      return;
    }
    constexpr unsigned kAll = 7;
    const std::size_t before = minima_.size();
    ++work_.triangle_pairs;
    test(tick.tested_a(explored_[next].a, kAll, kAll), tick.tested_b(explored_[next].b, kAll, kAll));
    for (std::size_t i = before; i < minima_.size(); ++i)
      for (std::uint32_t a : triangles_at(tick.pair.a(), minima_[i].feature_a))
        for (std::uint32_t b : triangles_at(tick.pair.b(), minima_[i].feature_b)) add({a, b});
  }
}

}  // namespace palpate
