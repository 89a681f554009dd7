#include "engine/snch/kinetic_front.h"

#include <algorithm>
#include <array>

#include "engine/kernel/triangle_pair.h"
#include "engine/snch/coarse_certificate.h"
#include "engine/snch/feature_certificate.h"
#include "engine/snch/front_cell.h"
#include "engine/snch/near_minima.h"
#include "engine/snch/owned_triangle.h"

namespace palpate {
namespace {

// A part of the front is renewed every few ticks: at least so many entries, or this share of a large front.
constexpr std::uint32_t kRenewalTicks = 4;
constexpr std::size_t kLeastRenewed = 128;
constexpr std::size_t kRenewedShare = 16;
constexpr std::size_t kFirstLevels = 4;

// Pairs in the place of one: a face, three sides and three corners.
constexpr std::size_t kMostOpened = 7;

// Readings beyond this are set back to 0, so that float32 expiries stay fine.
constexpr double kLongReading = 0.25;

// Pairs of nodes that may be tested to renew a part of the front, of a budget for the whole tick.
std::uint64_t renewal_budget(std::uint64_t budget) {
  if (budget == KineticFront::kNoBudget) return budget;
  return std::min<std::uint64_t>(std::max(budget, KineticFront::kLeastBudget) / 8, 2 * kLeastRenewed);
}

// What that leaves to the scan: a pair may be two tests.
std::uint64_t scan_budget(std::uint64_t budget, std::uint64_t renewal) {
  if (budget == KineticFront::kNoBudget) return budget;
  return std::max(budget, KineticFront::kLeastBudget) - 2 * renewal;
}

}  // namespace

void KineticFront::Front::clear() {
  pairs.clear();
  leaves.clear();
  tiers.clear();
}

void KineticFront::Front::reserve(std::size_t room) {
  pairs.reserve(room);
  leaves.reserve(room / 2);
  tiers.reserve(leaves.capacity());
}

std::size_t KineticFront::Front::add_leaf(const NodePair& pair, const Until& until,
                                          const PairTiers& of_features) {
  leaves.add(pair, until);
  tiers.push_back(of_features);
  return tiers.size() - 1;
}

void KineticFront::Front::remove_leaf(std::size_t i) {
  leaves.remove(i);
  tiers[i] = tiers.back();
  tiers.pop_back();
}

struct KineticFront::Tick {
  const Tree& tree_a;
  const Tree& tree_b;
  const Placement& placement;
  double reach;  // A's normalised frame, as the next
  double touch;
  NodeBatch node_batch;
  FeaturePairTest feature_test;
  FeatureCertificate feature_certificate;
  CoarseCertificate coarse_a;  // features of A against nodes of B
  CoarseCertificate coarse_b;
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
  const std::uint64_t renewal = ++ticks_ % kRenewalTicks == 0 ? renewal_budget(budget) : 0;
  const double reach = model_b.radius() / a.frame.scale + cutoff;
  const FeaturePairTest::Limits limits{cutoff, touch, options.parallel_tolerance},
      widest{cutoff, touch, SearchOptions::kWidestTolerance};
  const Tree &tree_a = a_->tree(options.near_minima), &tree_b = b_->tree(options.near_minima);
  const MeshSide side_a{a, placement, false}, side_b{b, placement, true};
  Tick tick{tree_a,
            tree_b,
            placement,
            reach,
            touch,
            NodeBatch(tree_a, tree_b, placement, cutoff),
            FeaturePairTest(a, b, placement, limits, minima_),
            FeatureCertificate(a, b, placement, widest, odometer_->rate(), reach),
            CoarseCertificate(side_a, side_b, tick.feature_certificate, widest),
            CoarseCertificate(side_b, side_a, tick.feature_certificate, widest),
            found,
            scan_budget(budget, renewal)};
  if (options.near_minima) include_near_minima(tick, limits);
  scan(tick);
  if (found.cut) return forget();
  if (renewal > 0) renew(tick, renewal);
  if (std::max(odometer_->distance(), odometer_->angle()) > kLongReading) rebase();

  std::sort(found.overlaps.begin(), found.overlaps.end());
  grouper_.group(a, b, touch, minima_, found);
  if (options.near_minima)
    settle_near_minima(model_a.near_tree().creases, model_b.near_tree().creases, found.near_minima);
  to_metres(a.frame, found);
}

void KineticFront::fix(const Room& room) {
  fixed_ = true;
  front_.reserve(room.front);
  minima_.reserve(room.minima);
  open_.reserve(front_.pairs.capacity() + kOpenRoom);
  postponed_.reserve(open_.capacity());
  for (auto* indices : {&expired_pairs_.entries, &expired_leaves_.entries, &opened_, &held_})
    indices->reserve(front_.pairs.capacity());  // all may expire at once
  kept_.reserve(std::max(front_.pairs.capacity() / kRenewedShare, kLeastRenewed));
  grouper_.fix(minima_.capacity());
}

void KineticFront::unfix() {
  fixed_ = false;
  grouper_.fix(0);
}

Room KineticFront::used() const {
  return {front_.size(), minima_.size(), 0};
}

// For what settling a batch adds.
bool KineticFront::has_room_for_batch() const {
  return !fixed_ || (front_.has_room(NodeBatch::kMost) && has_room(open_, kMostOpened * NodeBatch::kMost));
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
  front_.clear();
  front_.pairs.add({0, 0}, Until::passed());
  opened_.clear();  // what an update left that found no memory
  held_.clear();
  kept_.clear();
  postponed_.clear();
  expired_pairs_.first = expired_leaves_.first = Expired::kLast;
  ticks_ = 0;
  renewed_levels_ = kFirstLevels;
}

// Where the budget does not suffice for all, nodes and triangles share it. What was postponed comes first.
void KineticFront::scan(Tick& tick) {
  work_.entries = front_.size();
  list_expired(front_.pairs, expired_pairs_);
  list_expired(front_.leaves, expired_leaves_);
  work_.expired = expired_pairs_.entries.size() + expired_leaves_.entries.size();
  open_.assign(postponed_.begin(), postponed_.end());
  settle_leaves(tick, tick.budget / 2);
  settle_open(tick);
  settle_pairs(tick);
  settle_open(tick);
  settle_leaves(tick, tick.budget);
  remove_opened();
  postponed_.assign(open_.begin(), open_.end());
  complete_ = open_.empty() && expired_pairs_.entries.empty() && expired_leaves_.entries.empty();
}

// From the last one, downwards; or from where the last tick could go no further, and around.
void KineticFront::list_expired(FrontList& list, Expired& expired) const {
  list.find_passed(readings().now(), expired.entries);
  auto& entries = expired.entries;
  std::rotate(entries.begin(), std::upper_bound(entries.begin(), entries.end(), expired.first),
              entries.end());
}

void KineticFront::settle_open(Tick& tick) {
  while (!open_.empty() && !tick.found.cut) {
    if (!has_room_for_batch()) tick.found.cut = true;
    const std::size_t count = affordable(tick, tick.budget);
    if (tick.found.cut || count == 0) return;
    settle_last(tick, count, true);
  }
}

void KineticFront::settle_pairs(Tick& tick) {
  settle_expired(tick, tick.budget, expired_pairs_, [&](std::span<const std::uint32_t> batch) {
    if (has_room_for_batch()) return settle_pair_batch(tick, batch);
    tick.found.cut = true;
  });
}

void KineticFront::settle_leaves(Tick& tick, std::uint64_t budget) {
  settle_expired(tick, budget, expired_leaves_,
                 [&](std::span<const std::uint32_t> batch) { settle_leaf_batch(tick, batch); });
}

template <class Settle>
void KineticFront::settle_expired(Tick& tick, std::uint64_t budget, Expired& expired, const Settle& settle) {
  auto& entries = expired.entries;
  while (!entries.empty() && !tick.found.cut) {
    const std::size_t count = std::min(affordable(tick, budget), entries.size());
    if (count == 0) break;
    settle(std::span(entries).last(count));
    entries.resize(entries.size() - count);
  }
  expired.first = entries.empty() ? Expired::kLast : entries.back();
}

// How many pairs may still be tested: each may be a test of two nodes and of two triangles.
std::size_t KineticFront::affordable(const Tick& tick, std::uint64_t budget) {
  const std::uint64_t spent = tick.found.work.node_pairs + tick.found.work.triangle_pairs;
  return spent < budget
             ? static_cast<std::size_t>(std::min<std::uint64_t>((budget - spent) / 2, NodeBatch::kMost))
             : 0;
}

// Tests the last open pairs, at most `most`, together.
std::size_t KineticFront::settle_last(Tick& tick, std::size_t most, bool collect) {
  std::array<NodePair, NodeBatch::kMost> pairs;
  const std::size_t count = std::min({most, open_.size(), pairs.size()});
  std::copy(open_.end() - static_cast<std::ptrdiff_t>(count), open_.end(), pairs.begin());
  open_.resize(open_.size() - count);
  NodeBatch::Certificates certificates;
  tick.node_batch.certify({pairs.data(), count}, odometer_->rate(), tick.reach, certificates);
  tick.found.work.node_pairs += count;
  for (std::size_t i = 0; i < count; ++i) {
    const Certificate certificate = certificate_of(tick, pairs[i], certificates.of(i));
    if (certificate.holds()) {
      front_.pairs.add(pairs[i], readings().until(certificate));
    } else {
      open(tick, pairs[i], collect);
    }
  }
  return count;
}

// Most are pruned for another while, and stay where they are.
void KineticFront::settle_pair_batch(Tick& tick, std::span<const std::uint32_t> entries) {
  NodeBatch::Certificates certificates;
  const std::span<const NodePair> pairs = certify(tick, front_.pairs, entries, certificates);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Certificate certificate = certificate_of(tick, pairs[i], certificates.of(i));
    if (certificate.holds()) {
      front_.pairs.set_until(entries[i], readings().until(certificate));
    } else {
      opened_.push_back(entries[i]);
      open(tick, pairs[i], true);
    }
  }
}

// The bounds of two triangles may clear each other again, which is seen at once for many.
void KineticFront::settle_leaf_batch(Tick& tick, std::span<const std::uint32_t> leaves) {
  NodeBatch::Certificates certificates;
  const std::span<const NodePair> pairs = certify(tick, front_.leaves, leaves, certificates);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const Certificate certificate = certificate_of(tick, pairs[i], certificates.of(i));
    if (certificate.holds()) {
      front_.leaves.set_until(leaves[i], readings().until(certificate));
    } else {
      test_triangles(tick, leaves[i], true);
    }
  }
}

// Those of a list that a batch holds.
std::span<const NodePair> KineticFront::certify(Tick& tick, const FrontList& list,
                                                std::span<const std::uint32_t> entries,
                                                NodeBatch::Certificates& certificates) {
  for (std::size_t i = 0; i < entries.size(); ++i) batch_[i] = list[entries[i]];
  const std::span<const NodePair> pairs(batch_.data(), entries.size());
  tick.node_batch.certify(pairs, odometer_->rate(), tick.reach, certificates);
  tick.found.work.node_pairs += entries.size();
  return pairs;
}

// What has no certificate: two triangles, or nodes whose children are next.
void KineticFront::open(Tick& tick, NodePair pair, bool collect) {
  const PackedNode &a = tick.tree_a.packed(FeatureNode(pair.a).node()),
                   &b = tick.tree_b.packed(FeatureNode(pair.b).node());
  const bool whole = !FeatureNode(pair.a).is_feature() && !FeatureNode(pair.b).is_feature();
  if (a.is_leaf() && b.is_leaf()) {
    if (!collect && add_kept_leaf(pair)) return;
    test_triangles(tick, front_.add_leaf(pair, Until::passed(), {}), collect);
  } else if (whole && tick.node_batch.opens_features(a, b)) {
    open_features(a.is_leaf() ? tick.tree_a : tick.tree_b, pair, b.is_leaf());
  } else if (tick.node_batch.opens_first(a, b)) {
    open_.push_back({a.second_child(), pair.b});
    open_.push_back({pair.a + 1, pair.b});
  } else {
    open_.push_back({pair.a, b.second_child()});
    open_.push_back({pair.a, pair.b + 1});
  }
}

void KineticFront::remove_opened() {
  std::sort(opened_.begin(), opened_.end());
  for (; !opened_.empty(); opened_.pop_back()) front_.pairs.remove(opened_.back());
}

// What the bounds say, or the features if one is in the place of its triangle.
Certificate KineticFront::certificate_of(const Tick& tick, NodePair pair, Certificate bounds) const {
  const FeatureNode a(pair.a), b(pair.b);
  if ((!a.is_feature() && !b.is_feature()) || tick.feature_certificate.is_long(bounds)) return bounds;
  const Certificate features =
      a.is_feature() ? tick.coarse_a(tested(tick, a.node(), false), a.place(), tick.tree_b.node(b.node()))
                     : tick.coarse_b(tested(tick, b.node(), true), b.place(), tick.tree_a.node(a.node()));
  return longer(bounds, features, odometer_->rate());
}

void KineticFront::open_features(const Tree& tree, NodePair pair, bool of_b) {
  const std::uint32_t leaf = of_b ? pair.b : pair.a;
  const OwnedFeatures owned = tree.owned(tree.packed(leaf).triangle());
  const unsigned corners = owned.corners | owned.near_corners, sides = owned.sides | owned.near_sides;
  const unsigned places = corners | sides << 3 | 1u << TrianglePlace::kFace;
  for (std::uint8_t code = 0; code <= TrianglePlace::kFace; ++code) {
    if (!(places >> code & 1u)) continue;
    (of_b ? pair.b : pair.a) = FeatureNode::code_of(leaf, {code});
    open_.push_back(pair);
  }
}

FeaturePairSet KineticFront::feature_pairs(const NodePair& pair) {
  const FeatureNode a(pair.a), b(pair.b);
  if (a.is_feature()) return FeaturePairSet::of(false, a.place());
  return b.is_feature() ? FeaturePairSet::of(true, b.place()) : FeaturePairSet::all();
}

TestedTriangle KineticFront::tested(const Tick& tick, std::uint32_t node, bool of_b) const {
  return of_b ? owned_triangle(tick.tree_b, b_->mesh(), tick.tree_b.packed(node).triangle(), tick.placement)
              : owned_triangle(tick.tree_a, a_->mesh(), tick.tree_a.packed(node).triangle());
}

// Certificates prove that there is nothing now, either; pairs of features without one are looked at.
void KineticFront::test_triangles(Tick& tick, std::size_t leaf, bool collect) {
  const NodePair pair = front_.leaves[leaf];
  const PairTiers& tiers = front_.tiers[leaf];
  const FeaturePairSet due = tiers.untested() ? feature_pairs(pair) : tiers.due(readings().now());
  if (due.empty()) return front_.leaves.set_until(leaf, tiers.first());
  ++tick.found.work.triangle_pairs;
  const TestedTriangle a = tested(tick, FeatureNode(pair.a).node(), false);
  const TestedTriangle b = tested(tick, FeatureNode(pair.b).node(), true);
  front_.leaves.set_until(leaf, certify_features(tick, a, b, feature_pairs(pair), due, front_.tiers[leaf]));
  const FeaturePairSet doubtful = certificates_.doubtful();
  if (collect && !doubtful.empty()) collect_features(tick, a, b, doubtful);
}

// Until when the triangles are too far apart, or the first of their pairs of features is due again. Some
// certificates hold while that of contact does: where it ends all are tested.
Until KineticFront::certify_features(const Tick& tick, const TestedTriangle& a, const TestedTriangle& b,
                                     FeaturePairSet all, FeaturePairSet due, PairTiers& tiers) {
  const bool apart = all == FeaturePairSet::all();
  const Certificate far = tick.feature_certificate(a, b, due, apart, certificates_);
  if (far.holds()) return readings().until(far);
  if (certificates_.may_touch() && due != all) tick.feature_certificate(a, b, all, apart, certificates_);
  tiers.renew(certificates_, odometer_->rate(), readings());
  return tiers.first();
}

void KineticFront::collect_features(Tick& tick, const TestedTriangle& a, const TestedTriangle& b,
                                    FeaturePairSet among) {
  if (among.has(FeaturePairSet::kContact) && triangles_touch(a.shape, b.shape, tick.touch))
    tick.found.add_overlap({a.index, b.index}, options_.max_overlaps);
  if (fixed_ && !has_room_for_finds(tick)) {
    tick.found.cut = true;
    return;
  }
  tick.feature_test(a, b, among);
  if (tick.near_test) (*tick.near_test)(a, b, among);
}

// Takes a part of the front away and descends there anew, as far as it need be now.
void KineticFront::renew(Tick& tick, std::uint64_t budget) {
  if (front_.size() == 0 || (fixed_ && !has_room(postponed_, kOpenRoom))) return;
  const std::size_t entries = std::max(front_.size() / kRenewedShare, kLeastRenewed);
  take_out(choose_cell(tick, std::min<std::uint64_t>(entries, budget / 2)));
  std::size_t left = std::min<std::uint64_t>(2 * entries, budget);
  while (left > 0 && !open_.empty() && has_room_for_batch()) {
    const std::size_t count = settle_last(tick, left, false);
    left -= count;
    work_.rebuilt += count;
  }
  postponed_.insert(postponed_.end(), open_.begin(), open_.end());
  kept_.clear();
}

// Opens a cell in the place of all that it holds.
void KineticFront::take_out(const FrontCell& cell) {
  front_.pairs.find_held(cell, held_);
  for (; !held_.empty(); held_.pop_back()) front_.pairs.remove(held_.back());
  front_.leaves.find_held(cell, held_);
  for (; !held_.empty(); held_.pop_back()) {
    const std::uint32_t i = held_.back();
    if (!fixed_ || has_room(kept_, 1))
      kept_.push_back({front_.leaves[i], front_.leaves.until(i), front_.tiers[i]});
    front_.remove_leaf(i);
  }
  std::sort(kept_.begin(), kept_.end());
  std::erase_if(postponed_, [&](const NodePair& pair) { return cell.holds(whole_nodes(pair)); });
  open_.assign(1, cell.root);
}

bool KineticFront::add_kept_leaf(const NodePair& pair) {
  const auto kept = std::lower_bound(kept_.begin(), kept_.end(), KeptLeaf{pair, Until::passed(), {}});
  if (kept == kept_.end() || kept->nodes.a != pair.a || kept->nodes.b != pair.b) return false;
  front_.add_leaf(pair, kept->until, kept->tiers);
  return true;
}

// Around an entry that is chosen as if by chance, so that most are where most entries are: the highest cell
// that holds at most so many. It is looked for where such cells were lately.
FrontCell KineticFront::choose_cell(const Tick& tick, std::size_t most) {
  constexpr std::uint32_t kGoldenRatio = 0x9e3779b9;  // of 2³²: its multiples spread evenly
  const std::uint32_t chance = ticks_ / kRenewalTicks * kGoldenRatio;
  const NodePair chosen = front_[static_cast<std::size_t>(std::uint64_t{chance} * front_.size() >> 32)];
  const CellsAbove cells(tick.node_batch, tick.tree_a, tick.tree_b, whole_nodes(chosen));
  const auto holds_few = [&](std::size_t up) {
    return front_.pairs.count_held(cells[up]) + front_.leaves.count_held(cells[up]) <= most;
  };
  std::size_t up = std::min(renewed_levels_, cells.levels() - 1);
  while (up + 1 < cells.levels() && holds_few(up + 1)) ++up;
  while (up > 0 && !holds_few(up)) --up;
  renewed_levels_ = up;
  return cells[up];
}

void KineticFront::rebase() {
  front_.pairs.set_back(readings());
  front_.leaves.set_back(readings());
  for (PairTiers& tiers : front_.tiers) tiers.set_back(readings());
  odometer_->reset();
}

}  // namespace palpate
