#include "engine/snch/kinetic_front.h"

#include <algorithm>
#include <array>

#include "engine/kernel/triangle_pair.h"
#include "engine/snch/feature_certificate.h"
#include "engine/snch/near_minima.h"
#include "engine/snch/owned_triangle.h"

namespace palpate {
namespace {

// Pairs of nodes tested a tick for the next front: a front of 10,000 entries is renewed in about 300 ticks.
constexpr std::size_t kRebuildPairs = 48;

// Certificates lose this part, which covers the rounding of the odometer and of float32 expiries.
constexpr double kKept = 0.999;

// Readings beyond this are set back to 0 with a new front, so that float32 expiries stay fine.
constexpr double kLongReading = 0.25;

// Of a budget for a whole tick: a part renews the front, where a pair may be two tests.
std::size_t rebuild_budget(std::uint64_t budget) {
  budget = std::max(budget, KineticFront::kLeastBudget);
  return static_cast<std::size_t>(std::min<std::uint64_t>(budget / 8, kRebuildPairs));
}

std::uint64_t scan_budget(std::uint64_t budget) {
  return std::max(budget, KineticFront::kLeastBudget) - 2 * rebuild_budget(budget);
}

// A float32 below x if that is positive; not positive otherwise.
float rounded_down(double x) {
  return static_cast<float>(x) * (1.0f - 0x1p-23f);
}

// A float32 no less than x, which is not negative.
float rounded_up(double x) {
  return static_cast<float>(x) * (1.0f + 0x1p-22f);
}

}  // namespace

struct KineticFront::Tick {
  const Tree& tree_a;
  const Tree& tree_b;
  const Placement& placement;
  double reach;  // A's normalised frame, as the next
  double touch;
  NodeBatch node_batch;
  FeaturePairTest feature_test;
  FeatureCertificate feature_certificate;
  LmdSet& found;
  std::uint64_t budget;  // of the scan
  std::optional<NearMinimumTest> near_test = std::nullopt;
};

void KineticFront::update(const Model& model_a, const Model& model_b, const Pose& a_from_b,
                          const SearchOptions& options, LmdSet& found, std::uint64_t budget) {
  const Mesh &a = model_a.mesh(), &b = model_b.mesh();
  const Placement placement(a.frame, b.frame, a_from_b);
  const double cutoff = options.cutoff / a.frame.scale, touch = touching_distance(placement);
  found.clear();
  work_ = {};
  minima_.clear();
  const bool going_on = goes_on(model_a, model_b, options);
  a_ = &model_a;
  b_ = &model_b;
  options_ = options;
  going_on ? odometer_->advance(placement) : start(placement);
  const double reach = model_b.radius() / a.frame.scale + cutoff;
  const FeaturePairTest::Limits limits{cutoff, touch, options.parallel_tolerance};
  const Tree &tree_a = a_->tree(options.near_minima), &tree_b = b_->tree(options.near_minima);
  Tick tick{tree_a,
            tree_b,
            placement,
            reach,
            touch,
            NodeBatch(tree_a, tree_b, placement, cutoff),
            FeaturePairTest(a, b, placement, limits, minima_),
            FeatureCertificate(a, b, placement, {cutoff, touch, SearchOptions::kWidestTolerance},
                               odometer_->rate(), reach),
            found,
            scan_budget(budget)};
  if (options.near_minima) include_near_minima(tick, limits);
  scan(tick);
  if (found.cut) return forget();
  build_next_front(tick, rebuild_budget(budget));

  std::sort(found.overlaps.begin(), found.overlaps.end());
  grouper_.group(a, b, touch, minima_, found);
  if (options.near_minima)
    settle_near_minima(model_a.near_tree().creases, model_b.near_tree().creases, found.near_minima);
  to_metres(a.frame, found);
}

void KineticFront::fix(const Room& room) {
  fixed_ = true;
  front_.reserve(room.front);
  next_front_.reserve(room.front);
  next_open_.reserve(kOpenRoom);
  minima_.reserve(room.minima);
  // The two fronts change places, and all of one may expire at once.
  open_.reserve(std::max(front_.capacity(), next_front_.capacity()) + kOpenRoom);
  postponed_.reserve(open_.capacity());
  grouper_.fix(minima_.capacity());
}

void KineticFront::unfix() {
  fixed_ = false;
  grouper_.fix(0);
}

Room KineticFront::used() const {
  return {std::max(front_.size(), next_front_.size()), minima_.size(), 0};
}

// For what settling a batch adds to them.
bool KineticFront::has_room_for(const std::vector<Entry>& front, const std::vector<NodePair>& open) const {
  return !fixed_ || (has_room(front, NodeBatch::kMost) && has_room(open, NodeBatch::kMost));
}

// For what two triangles may hold.
bool KineticFront::has_room_for_finds(const Tick& tick) const {
  return has_room(minima_, FeaturePairTest::kMostFound) && has_near_room(tick.found.near_minima);
}

void KineticFront::include_near_minima(Tick& tick, const FeaturePairTest::Limits& limits) const {
  const Creases &a = a_->near_tree().creases, &b = b_->near_tree().creases;
  tick.feature_certificate.include_near_minima(a, b);
  tick.near_test.emplace(NearPolar({a_->mesh(), tick.placement, false}, a),
                         NearPolar({b_->mesh(), tick.placement, true}, b), limits, tick.found.near_minima);
}

bool KineticFront::goes_on(const Model& a, const Model& b, const SearchOptions& options) const {
  return odometer_ && &a == a_ && &b == b_ && options.cutoff == options_.cutoff &&
         options.near_minima == options_.near_minima;
}

void KineticFront::start(const Placement& placement) {
  const ModelFrame &to = a_->mesh().frame, &from = b_->mesh().frame;
  odometer_.emplace((b_->centre() - from.origin) / from.scale, (b_->radius() + options_.cutoff) / to.scale);
  odometer_->start(placement);
  front_.assign(1, {0, 0, -1.0f, -1.0f});
  postponed_.clear();
  next_front_.clear();
  next_open_.assign(1, {0, 0});
}

void KineticFront::scan(Tick& tick) {
  const float distance = rounded_up(odometer_->distance()), angle = rounded_up(odometer_->angle());
  work_.entries = front_.size();
  open_.clear();
  std::size_t kept = 0;
  for (const Entry& entry : front_) {
    if (distance < entry.until_distance && angle < entry.until_angle) {
      front_[kept++] = entry;
    } else {
      open_.push_back({entry.a, entry.b});
    }
  }
  front_.resize(kept);
  work_.expired = open_.size();
  if (fixed_ && !has_room(open_, postponed_.size())) tick.found.cut = true;
  if (tick.found.cut) return;
  open_.insert(open_.end(), postponed_.begin(), postponed_.end());  // the last is tested first
  while (!open_.empty()) {
    if (!has_room_for(front_, open_)) tick.found.cut = true;
    const std::size_t count = affordable(tick);
    if (tick.found.cut || count == 0) break;
    settle_last(tick, count, front_, open_, true);
  }
  postponed_.assign(open_.begin(), open_.end());
  complete_ = open_.empty();
}

// How many pairs the scan may still test: each may be a test of two nodes and of two triangles.
std::size_t KineticFront::affordable(const Tick& tick) const {
  const std::uint64_t spent = tick.found.work.node_pairs + tick.found.work.triangle_pairs;
  return static_cast<std::size_t>(std::min<std::uint64_t>((tick.budget - spent) / 2, NodeBatch::kMost));
}

// Tests the last open pairs, at most `most`, together.
void KineticFront::settle_last(Tick& tick, std::size_t most, std::vector<Entry>& front,
                               std::vector<NodePair>& open, bool collect) {
  std::array<NodePair, NodeBatch::kMost> pairs;
  const std::size_t count = std::min({most, open.size(), pairs.size()});
  std::copy(open.end() - static_cast<std::ptrdiff_t>(count), open.end(), pairs.begin());
  open.resize(open.size() - count);
  NodeBatch::Certificates certificates;
  tick.node_batch.certify({pairs.data(), count}, odometer_->rate(), tick.reach, certificates);
  for (std::size_t i = 0; i < count; ++i) settle(tick, pairs[i], certificates.of(i), front, open, collect);
}

// Puts a pair on the front if it can be pruned or holds two triangles; otherwise opens its children.
void KineticFront::settle(Tick& tick, NodePair pair, Certificate certificate, std::vector<Entry>& front,
                          std::vector<NodePair>& open, bool collect) {
  ++tick.found.work.node_pairs;
  const Node &a = tick.tree_a.node(pair.a), &b = tick.tree_b.node(pair.b);
  if (!certificate.holds() && !(a.is_leaf() && b.is_leaf())) {
    if (tick.node_batch.opens_first(a, b)) {
      open.push_back({a.second_child(), pair.b});
      open.push_back({pair.a + 1, pair.b});
    } else {
      open.push_back({pair.a, b.second_child()});
      open.push_back({pair.a, pair.b + 1});
    }
    return;
  }
  if (!certificate.holds()) certificate = test_triangles(tick, a.triangle(), b.triangle(), collect);
  front.push_back(entry_of(pair, certificate));
}

// A certificate proves that there is nothing now, either; without one the pair is looked at.
Certificate KineticFront::test_triangles(Tick& tick, std::uint32_t a, std::uint32_t b, bool collect) {
  ++tick.found.work.triangle_pairs;
  const TestedTriangle tested_a = owned_triangle(tick.tree_a, a_->mesh(), a);
  const TestedTriangle tested_b = owned_triangle(tick.tree_b, b_->mesh(), b, tick.placement);
  const Certificate certificate = tick.feature_certificate(tested_a, tested_b);
  if (certificate.holds() || !collect) return certificate;
  if (triangles_touch(tested_a.shape, tested_b.shape, tick.touch))
    tick.found.add_overlap({a, b}, options_.max_overlaps);
  if (fixed_ && !has_room_for_finds(tick)) {
    tick.found.cut = true;
    return {};
  }
  tick.feature_test(tested_a, tested_b);
  if (tick.near_test) (*tick.near_test)(tested_a, tested_b);
  return {};
}

void KineticFront::build_next_front(Tick& tick, std::size_t most) {
  for (std::size_t left = most; left > 0 && !next_open_.empty();) {
    if (!has_room_for(next_front_, next_open_)) {
      next_front_.clear();
      next_open_.assign(1, {0, 0});
      return;
    }
    const std::size_t count = std::min({left, next_open_.size(), NodeBatch::kMost});
    settle_last(tick, count, next_front_, next_open_, false);
    left -= count;
    work_.rebuilt += count;
  }
  if (!next_open_.empty()) return;
  front_.swap(next_front_);
  postponed_.clear();  // the next front has a place for them
  next_front_.clear();
  next_open_.assign(1, {0, 0});
  if (std::max(odometer_->distance(), odometer_->angle()) > kLongReading) rebase();
}

void KineticFront::rebase() {
  for (Entry& entry : front_) {
    entry.until_distance = rounded_down(entry.until_distance - odometer_->distance());
    entry.until_angle = rounded_down(entry.until_angle - odometer_->angle());
  }
  odometer_->reset();
}

KineticFront::Entry KineticFront::entry_of(NodePair pair, const Certificate& certificate) const {
  if (!certificate.holds()) return {pair.a, pair.b, -1.0f, -1.0f};
  return {pair.a, pair.b, rounded_down(odometer_->distance() + kKept * certificate.distance),
          rounded_down(odometer_->angle() + kKept * certificate.angle)};
}

}  // namespace palpate
