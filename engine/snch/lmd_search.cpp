#include "engine/snch/lmd_search.h"

#include <algorithm>
#include <array>
#include <optional>

#include "engine/kernel/triangle_pair.h"
#include "engine/snch/feature_pairs.h"
#include "engine/snch/near_minima.h"
#include "engine/snch/node_batch.h"
#include "engine/snch/owned_triangle.h"
#include "engine/snch/plateau.h"

namespace palpate {
namespace {

// A pair of nodes still to be visited, and for what.
struct OpenPair {
  NodePair nodes;
  bool minimum;
  bool contact;
};

// One traversal: carries the state that its small steps share.
class Traversal {
 public:
  Traversal(const Model& a, const Model& b, const Placement& placement, double cutoff,
            const SearchOptions& options, std::vector<OpenPair>& stack, std::vector<Minimum>& minima,
            bool fixed, LmdSet& found)
      : a_(a.tree(options.near_minima)),
        b_(b.tree(options.near_minima)),
        a_mesh_(a.mesh()),
        b_mesh_(b.mesh()),
        placement_(placement),
        touch_(touching_distance(placement)),
        max_overlaps_(options.max_overlaps),
        batch_(a_, b_, placement, cutoff),
        feature_test_(a.mesh(), b.mesh(), placement, {cutoff, touch_, options.parallel_tolerance}, minima),
        stack_(stack),
        minima_(minima),
        fixed_(fixed),
        found_(found) {
    if (!options.near_minima) return;
    near_test_.emplace(NearPolar({a_mesh_, placement_, false}, a.near_tree().creases),
                       NearPolar({b_mesh_, placement_, true}, b.near_tree().creases),
                       NearMinimumTest::Limits{cutoff, touch_, options.parallel_tolerance},
                       found.near_minima);
  }

  void run() {
    stack_.assign(1, {{0, 0}, true, true});
    while (!stack_.empty()) visit_last();
  }

 private:
  // Visits as many of the last pairs as are judged together.
  void visit_last() {
    std::array<OpenPair, NodeBatch::kMost> open;
    std::array<NodePair, NodeBatch::kMost> nodes;
    const std::size_t count = std::min(stack_.size(), open.size());
    std::copy(stack_.end() - static_cast<std::ptrdiff_t>(count), stack_.end(), open.begin());
    stack_.resize(stack_.size() - count);
    for (std::size_t i = 0; i < count; ++i) nodes[i] = open[i].nodes;
    NodeBatch::Verdicts verdicts;
    batch_.judge({nodes.data(), count}, verdicts);
    for (std::size_t i = 0; i < count; ++i) visit(open[i], verdicts[i]);
  }

  void visit(OpenPair pair, NodeBatch::Verdict verdict) {
    ++found_.work.node_pairs;
    pair.minimum &= verdict.minimum;
    pair.contact &= verdict.contact && !found_.overlaps_cut;
    if (!pair.minimum && !pair.contact) return;
    const auto [index_a, index_b] = pair.nodes;
    const PackedNode &a = a_.packed(index_a), &b = b_.packed(index_b);
    if (a.is_leaf() && b.is_leaf()) return test_triangles(a.triangle(), b.triangle(), pair);
    if (fixed_ && !has_room(stack_, 2)) {
      found_.cut = true;
    } else if (batch_.opens_first(a, b)) {
      stack_.push_back({{a.second_child(), index_b}, pair.minimum, pair.contact});
      stack_.push_back({{index_a + 1, index_b}, pair.minimum, pair.contact});
    } else {
      stack_.push_back({{index_a, b.second_child()}, pair.minimum, pair.contact});
      stack_.push_back({{index_a, index_b + 1}, pair.minimum, pair.contact});
    }
  }

  void test_triangles(std::uint32_t a, std::uint32_t b, const OpenPair& pair) {
    ++found_.work.triangle_pairs;
    const TestedTriangle tested_a = owned_triangle(a_, a_mesh_, a),
                         tested_b = owned_triangle(b_, b_mesh_, b, placement_);
    if (pair.contact && triangles_touch(tested_a.shape, tested_b.shape, touch_))
      found_.add_overlap({a, b}, max_overlaps_);
    if (!pair.minimum) return;
    if (fixed_ && !has_room_for_finds()) {
      found_.cut = true;
      return;
    }
    feature_test_(tested_a, tested_b);
    if (near_test_) (*near_test_)(tested_a, tested_b);
  }

  // For what two triangles may hold.
  bool has_room_for_finds() const {
    return has_room(minima_, FeaturePairTest::kMostFound) && has_near_room(found_.near_minima);
  }

  const Tree& a_;
  const Tree& b_;
  const Mesh& a_mesh_;
  const Mesh& b_mesh_;
  const Placement& placement_;
  const double touch_;
  const std::size_t max_overlaps_;
  NodeBatch batch_;
  FeaturePairTest feature_test_;
  std::optional<NearMinimumTest> near_test_;
  std::vector<OpenPair>& stack_;
  const std::vector<Minimum>& minima_;
  const bool fixed_;
  LmdSet& found_;
};

}  // namespace

struct LmdSearch::Memory {
  std::vector<OpenPair> stack;
  std::vector<Minimum> minima;
  PlateauGrouper grouper;
  bool fixed = false;
};

LmdSearch::LmdSearch() : memory_(std::make_unique<Memory>()) {}
LmdSearch::~LmdSearch() = default;
LmdSearch::LmdSearch(LmdSearch&&) noexcept = default;
LmdSearch& LmdSearch::operator=(LmdSearch&&) noexcept = default;

void LmdSearch::fix(const Room& room) {
  memory_->fixed = true;
  memory_->stack.reserve(kOpenRoom);
  std::vector<Minimum>().swap(memory_->minima);  // may have grown past what `found` has room for
  memory_->minima.reserve(room.minima);
  memory_->grouper.fix(memory_->minima.capacity());
}

void LmdSearch::unfix() {
  memory_->fixed = false;
  memory_->grouper.fix(0);
}

void LmdSearch::run(const Model& a, const Model& b, const Pose& a_from_b, const SearchOptions& options,
                    LmdSet& found) {
  const ModelFrame& frame = a.mesh().frame;
  const Placement placement(frame, b.mesh().frame, a_from_b);
  found.clear();
  memory_->minima.clear();
  Traversal(a, b, placement, options.cutoff / frame.scale, options, memory_->stack, memory_->minima,
            memory_->fixed, found)
      .run();
  std::sort(found.overlaps.begin(), found.overlaps.end());
  memory_->grouper.group(a.mesh(), b.mesh(), touching_distance(placement), memory_->minima, found);
  if (options.near_minima)
    settle_near_minima(a.near_tree().creases, b.near_tree().creases, found.near_minima);
  to_metres(frame, found);
}

}  // namespace palpate
