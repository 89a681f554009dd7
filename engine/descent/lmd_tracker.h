#pragma once

#include <span>
#include <vector>

#include "engine/descent/descent_pair.h"
#include "engine/descent/feature_walk.h"
#include "engine/descent/neighbourhood_descent.h"
#include "engine/descent/polar_descent.h"
#include "engine/descent/seed.h"
#include "engine/snch/feature_pairs.h"
#include "engine/snch/lmd_search.h"
#include "engine/snch/plateau.h"

namespace palpate {

enum class DescentForm { kPolar, kNeighbourhood };

// Follows the local minimum distances of two models from pose to pose by local descent. It finds no new ones:
// those come from a search, which may be of an older pose. What does not end in a local minimum is dropped,
// what takes too many steps goes on at the next pose, what meets at one place is merged. The cost is that of
// the LMDs, not of the models. Keeps its memory from call to call.
class LmdTracker {
 public:
  explicit LmdTracker(DescentForm form = DescentForm::kPolar) : form_(form) {}

  // Adds the LMDs of a search to those that are followed.
  void adopt(const Mesh& a, const Mesh& b, const LmdSet& searched);

  // Adds what may be reached from pairs of triangles, which may touch.
  void adopt(std::span<const TrianglePair> seeds);

  // Brings all to a new pose and goes on following those within options.cutoff. `found` receives those within
  // `cutoff` (metres), which is no larger, and its work the pairs measured.
  void follow(const Mesh& a, const Mesh& b, const Pose& a_from_b, const SearchOptions& options, double cutoff,
              LmdSet& found);

  // Allocates nothing any more: what finds no room is cut, and flagged. Needs a `found` with the same room.
  void fix(const Room& room);
  void unfix();
  std::size_t used_minima() const { return minima_.size(); }
  bool tight() const { return is_tight(seeds_) || is_tight(minima_); }

  void forget() { seeds_.clear(); }
  std::size_t size() const { return seeds_.size(); }
  const DescentWork& work() const { return work_; }  // of the last follow()

 private:
  struct Tick;
  bool has_room_for_test() const;
  void follow_seed(const Tick& tick, const Seed& seed, FeaturePairTest& test, LmdSet& found);
  bool stands(const Tick& tick, const Seed& seed, FeaturePairTest& test);
  Seed walked(const DescentPair& pair, const Seed& seed);
  bool alone_since(std::size_t before) const;
  bool descend(const DescentPair& pair, DescentPoint& point);
  void decide(const Tick& tick, const DescentPoint& point, FeaturePairTest& test, LmdSet& found);
  void explore_plateau(const Tick& tick, TrianglePair from, FeaturePairTest& test, LmdSet& found);
  void sort_seeds();
  void add_seed(const Seed& seed);
  void remember(const Mesh& a, const Mesh& b, const LmdSet& found);

  DescentForm form_;
  bool fixed_ = false;
  bool overflowed_ = false;  // seeds found no room
  PolarDescent polar_;
  NeighbourhoodDescent neighbourhood_;
  PlateauGrouper grouper_;
  std::vector<Seed> seeds_;
  std::vector<TrianglePair> unfinished_;  // where descents of this tick stand that go on in the next
  std::vector<TrianglePair> explored_;    // pairs of triangles of plateaus met in this tick
  std::vector<Minimum> minima_;
  DescentWork work_;
};

}  // namespace palpate
