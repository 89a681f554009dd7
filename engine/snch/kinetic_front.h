#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "engine/snch/feature_pair_set.h"
#include "engine/snch/feature_pairs.h"
#include "engine/snch/front_cell.h"
#include "engine/snch/front_list.h"
#include "engine/snch/lmd.h"
#include "engine/snch/lmd_search.h"
#include "engine/snch/model.h"
#include "engine/snch/node_batch.h"
#include "engine/snch/odometer.h"
#include "engine/snch/pair_certificates.h"
#include "engine/snch/pair_tiers.h"
#include "engine/snch/plateau.h"
#include "engine/snch/tested_triangle.h"

namespace palpate {

// Work of one tick of a kinetic front.
struct FrontWork {
  std::uint64_t entries = 0;  // of the front
  std::uint64_t expired = 0;  // of those, tested again
  std::uint64_t rebuilt = 0;  // pairs tested to renew a part of it
};

// The complete set of local minimum distances of two models along a motion, with proof in every tick:
// certified coherence. The front of a traversal, the pairs of nodes where it was pruned and the pairs of
// triangles that it reached, is kept from tick to tick. Each entry has a certificate on the odometer of the
// relative motion; while that holds, the entry need not be looked at. A tick scans the front, tests again
// what has expired, and descends there, so no LMD is late and none is missed. Of two triangles each pair of
// features has its own certificate, and only those that may have ended are tested again. By that the front
// only grows finer: a small part of it is renewed every few ticks from above, to be no finer than it need be.
//
// A tick may be given a budget of tests. What it leaves untested comes first in the next tick, so that
// nothing is lost: the set is complete again as soon as the budget suffices.
//
// After: kinetic data structures (Basch, Guibas & Hershberger 1997) and front tracking (Klosowski et al.
// 1998).
class KineticFront {
 public:
  static constexpr std::uint64_t kNoBudget = std::numeric_limits<std::uint64_t>::max();
  static constexpr std::uint64_t kLeastBudget = 128;  // less would not get ahead

  // Fills `found` with the complete set at this pose, or with a part of it if more than `budget` tests of
  // pairs of nodes and of triangles would be needed. Other models, or another cutoff than last
  // time, start afresh. The models must live until the next update or forget().
  void update(const Model& a, const Model& b, const Pose& a_from_b, const SearchOptions& options,
              LmdSet& found, std::uint64_t budget = kNoBudget);

  bool complete() const { return complete_; }  // what the last update found

  // Allocates nothing any more: a front that outgrows its room is given up, and `found` is cut, and flagged.
  // Needs a `found` with the same room.
  void fix(const Room& room);
  void unfix();
  Room used() const;  // by the last update
  bool tight() const { return front_.is_tight() || is_tight(minima_); }

  // Starts afresh next time; keeps the memory.
  void forget() { odometer_.reset(); }

  const FrontWork& work() const { return work_; }  // of the last update

 private:
  struct Front {
    FrontList pairs;               // of nodes that hold nothing for a time
    FrontList leaves;              // of triangles whose pairs of features have been tested
    std::vector<PairTiers> tiers;  // of the leaves

    void clear();
    void reserve(std::size_t room);
    bool has_room(std::size_t count) const {
      return pairs.capacity() - pairs.size() >= count && leaves.capacity() - leaves.size() >= count;
    }
    bool is_tight() const {
      return pairs.size() > pairs.capacity() / 2 || leaves.size() > leaves.capacity() / 2;
    }
    std::size_t size() const { return pairs.size() + leaves.size(); }
    NodePair operator[](std::size_t i) const {
      return i < pairs.size() ? pairs[i] : leaves[i - pairs.size()];
    }
    std::size_t add_leaf(const NodePair& pair, const Until& until, const PairTiers& of_features);
    void remove_leaf(std::size_t i);
  };
  // Entries of one list that are to be tested, by index; the last is the first.
  struct Expired {
    std::vector<std::uint32_t> entries;
    std::uint32_t first = kLast;  // that the last tick could not afford

    static constexpr std::uint32_t kLast = std::numeric_limits<std::uint32_t>::max();
  };
  // A leaf that was taken out, until a traversal comes to it again.
  struct KeptLeaf {
    NodePair nodes;
    Until until;
    PairTiers tiers;

    friend bool operator<(const KeptLeaf& one, const KeptLeaf& other) {
      return std::tie(one.nodes.a, one.nodes.b) < std::tie(other.nodes.a, other.nodes.b);
    }
  };
  struct Tick;

  bool has_room_for_finds(const Tick& tick) const;
  void include_near_minima(Tick& tick, const FeaturePairTest::Limits& limits) const;
  bool goes_on(const Model& a, const Model& b, const SearchOptions& options) const;
  void start(const Placement& placement);
  void scan(Tick& tick);
  void list_expired(FrontList& list, Expired& expired) const;
  void settle_open(Tick& tick);
  void settle_pairs(Tick& tick);
  void settle_leaves(Tick& tick, std::uint64_t budget);
  template <class Settle>
  void settle_expired(Tick& tick, std::uint64_t budget, Expired& expired, const Settle& settle);
  bool has_room_for_batch() const;
  static std::size_t affordable(const Tick& tick, std::uint64_t budget);
  std::size_t settle_last(Tick& tick, std::size_t most, bool collect);
  void settle_pair_batch(Tick& tick, std::span<const std::uint32_t> entries);
  void settle_leaf_batch(Tick& tick, std::span<const std::uint32_t> leaves);
  std::span<const NodePair> certify(Tick& tick, const FrontList& list, std::span<const std::uint32_t> entries,
                                    NodeBatch::Certificates& certificates);
  Certificate certificate_of(const Tick& tick, NodePair pair, Certificate bounds) const;
  void open(Tick& tick, NodePair pair, bool collect);
  void open_features(const Tree& tree, NodePair pair, bool of_b);
  bool add_kept_leaf(const NodePair& pair);
  void remove_opened();
  static NodePair whole_nodes(const NodePair& pair) {
    return {FeatureNode(pair.a).node(), FeatureNode(pair.b).node()};
  }
  static FeaturePairSet feature_pairs(const NodePair& pair);
  TestedTriangle tested(const Tick& tick, std::uint32_t node, bool of_b) const;
  void test_triangles(Tick& tick, std::size_t leaf, bool collect);
  Until certify_features(const Tick& tick, const TestedTriangle& a, const TestedTriangle& b,
                         FeaturePairSet all, FeaturePairSet due, PairTiers& tiers);
  void collect_features(Tick& tick, const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among);
  void renew(Tick& tick, std::uint64_t budget);
  FrontCell choose_cell(const Tick& tick, std::size_t most);
  void take_out(const FrontCell& cell);
  void rebase();
  Readings readings() const { return Readings(*odometer_); }

  bool fixed_ = false;
  const Model* a_ = nullptr;
  const Model* b_ = nullptr;
  SearchOptions options_;
  std::optional<Odometer> odometer_;
  Front front_;
  std::array<NodePair, NodeBatch::kMost> batch_;
  std::vector<NodePair> open_;
  std::vector<NodePair> postponed_;  // pairs that are not on the front: the last tick could not afford them
  Expired expired_pairs_;
  Expired expired_leaves_;
  std::vector<std::uint32_t> opened_;  // of the pairs on the front, to be removed
  std::vector<std::uint32_t> held_;    // by a cell
  std::vector<KeptLeaf> kept_;         // of a cell that is renewed, ascending
  std::uint32_t ticks_ = 0;            // since the start
  std::size_t renewed_levels_ = 0;     // above an entry, where the last part was found that was renewed
  bool complete_ = true;
  PairCertificates certificates_;
  std::vector<Minimum> minima_;
  PlateauGrouper grouper_;
  FrontWork work_;
};

}  // namespace palpate
