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

// Certificates lose this part, which covers the rounding of the odometer and of float32 expiries.
constexpr double kKept = 0.999;

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

// A float32 below x if that is positive; not positive otherwise.
float rounded_down(double x) {
  return static_cast<float>(x) * (1.0f - 0x1p-23f);
}

// A float32 no less than x, which is not negative.
float rounded_up(double x) {
  return static_cast<float>(x) * (1.0f + 0x1p-22f);
}

}  // namespace

void KineticFront::Front::clear() {
  pairs.clear();
  leaves.clear();
}

void KineticFront::Front::reserve(std::size_t room) {
  pairs.reserve(room);
  leaves.reserve(room / 2);
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
  open_.reserve(front_.pairs.capacity() + kOpenRoom);  // all may expire at once
  postponed_.reserve(open_.capacity());
  expired_leaves_.reserve(front_.leaves.capacity());
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
  return !fixed_ || (has_room(front_.pairs, NodeBatch::kMost) && has_room(front_.leaves, NodeBatch::kMost) &&
                     has_room(open_, kMostOpened * NodeBatch::kMost));
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
  front_.pairs.push_back({{0, 0}, {-1.0f, -1.0f}});
  postponed_.clear();
  first_leaf_ = 0;
  ticks_ = 0;
  renewed_levels_ = kFirstLevels;
}

// Where the budget does not suffice for all, nodes and triangles share it.
void KineticFront::scan(Tick& tick) {
  work_.entries = front_.size();
  open_expired(tick);
  list_expired_leaves();
  work_.expired = open_.size() - postponed_.size() + expired_leaves_.size();
  settle_leaves(tick, tick.budget / 2);
  settle_open(tick, tick.budget);
  settle_leaves(tick, tick.budget);
  postponed_.assign(open_.begin(), open_.end());
  complete_ = open_.empty() && expired_leaves_.empty();
}

void KineticFront::open_expired(Tick& tick) {
  const Until now = this->now();
  open_.clear();
  std::size_t kept = 0;
  for (const Entry& entry : front_.pairs) {
    if (entry.until.passed(now)) {
      open_.push_back(entry.nodes);
    } else {
      front_.pairs[kept++] = entry;
    }
  }
  front_.pairs.resize(kept);
  if (fixed_ && !has_room(open_, postponed_.size())) tick.found.cut = true;
  if (!tick.found.cut) open_.insert(open_.end(), postponed_.begin(), postponed_.end());  // these are first
}

// From the first on that the last tick could not afford; the last one listed is tested first.
void KineticFront::list_expired_leaves() {
  const Until now = this->now();
  const std::span<const Leaf> leaves = front_.leaves;
  expired_leaves_.clear();
  const auto list = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = end; i-- > begin;)
      if (leaves[i].until.passed(now)) expired_leaves_.push_back(static_cast<std::uint32_t>(i));
  };
  const std::size_t first = std::min(first_leaf_, leaves.size());
  list(0, first);
  list(first, leaves.size());
}

void KineticFront::settle_open(Tick& tick, std::uint64_t budget) {
  while (!open_.empty() && !tick.found.cut) {
    if (!has_room_for_batch()) tick.found.cut = true;
    const std::size_t count = affordable(tick, budget);
    if (tick.found.cut || count == 0) return;
    settle_last(tick, count, true);
  }
}

void KineticFront::settle_leaves(Tick& tick, std::uint64_t budget) {
  while (!expired_leaves_.empty() && !tick.found.cut) {
    const std::size_t count = std::min(affordable(tick, budget), expired_leaves_.size());
    if (count == 0) break;
    const std::size_t left = expired_leaves_.size() - count;
    settle_leaf_batch(tick, std::span(expired_leaves_).subspan(left));
    expired_leaves_.resize(left);
  }
  first_leaf_ = expired_leaves_.empty() ? 0 : expired_leaves_.back();
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
  for (std::size_t i = 0; i < count; ++i)
    settle(tick, pairs[i], certificate_of(tick, pairs[i], certificates.of(i)), collect);
  return count;
}

// Puts a pair on the front if it can be pruned or holds two triangles; otherwise opens its children.
void KineticFront::settle(Tick& tick, NodePair pair, Certificate certificate, bool collect) {
  ++tick.found.work.node_pairs;
  if (certificate.holds()) return front_.pairs.push_back({pair, until(certificate)});
  const Node &a = tick.tree_a.node(FeatureNode(pair.a).node()),
             &b = tick.tree_b.node(FeatureNode(pair.b).node());
  const bool whole = !FeatureNode(pair.a).is_feature() && !FeatureNode(pair.b).is_feature();
  if (a.is_leaf() && b.is_leaf()) {
    test_triangles(tick, front_.leaves.emplace_back(Leaf{pair, kPassed, kPassed, {}}), collect);
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

// What the bounds say, or the features if one is in the place of its triangle.
Certificate KineticFront::certificate_of(const Tick& tick, NodePair pair, Certificate bounds) const {
  const FeatureNode a(pair.a), b(pair.b);
  if (!a.is_feature() && !b.is_feature()) return bounds;
  const Certificate features =
      a.is_feature() ? tick.coarse_a(tested(tick, a.node(), false), a.place(), tick.tree_b.node(b.node()))
                     : tick.coarse_b(tested(tick, b.node(), true), b.place(), tick.tree_a.node(a.node()));
  return longer(bounds, features, odometer_->rate());
}

void KineticFront::open_features(const Tree& tree, NodePair pair, bool of_b) {
  const std::uint32_t leaf = of_b ? pair.b : pair.a;
  const OwnedFeatures owned = tree.owned(tree.node(leaf).triangle());
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
  return of_b ? owned_triangle(tick.tree_b, b_->mesh(), tick.tree_b.node(node).triangle(), tick.placement)
              : owned_triangle(tick.tree_a, a_->mesh(), tick.tree_a.node(node).triangle());
}

// The bounds of two triangles may clear each other again, which is seen at once for many.
void KineticFront::settle_leaf_batch(Tick& tick, std::span<const std::uint32_t> leaves) {
  std::array<NodePair, NodeBatch::kMost> pairs;
  for (std::size_t i = 0; i < leaves.size(); ++i) pairs[i] = front_.leaves[leaves[i]].nodes;
  NodeBatch::Certificates certificates;
  tick.node_batch.certify({pairs.data(), leaves.size()}, odometer_->rate(), tick.reach, certificates);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    ++tick.found.work.node_pairs;
    Leaf& leaf = front_.leaves[leaves[i]];
    const Certificate certificate = certificate_of(tick, leaf.nodes, certificates.of(i));
    if (certificate.holds()) {
      leaf.until = until(certificate);
    } else {
      test_triangles(tick, leaf, true);
    }
  }
}

// Certificates prove that there is nothing now, either; pairs of features without one are looked at.
void KineticFront::test_triangles(Tick& tick, Leaf& leaf, bool collect) {
  ++tick.found.work.triangle_pairs;
  const TestedTriangle tested_a = tested(tick, FeatureNode(leaf.nodes.a).node(), false);
  const TestedTriangle tested_b = tested(tick, FeatureNode(leaf.nodes.b).node(), true);
  certify_features(tick, leaf, tested_a, tested_b);
  const FeaturePairSet doubtful = certificates_.doubtful();
  if (collect && !doubtful.empty()) collect_features(tick, tested_a, tested_b, doubtful);
}

void KineticFront::certify_features(Tick& tick, Leaf& leaf, const TestedTriangle& a,
                                    const TestedTriangle& b) {
  const bool whole = leaf.rest.passed(now());
  const FeaturePairSet due = whole ? feature_pairs(leaf.nodes) : leaf.due;
  const Certificate far = tick.feature_certificate(a, b, due, certificates_);
  if (far.holds()) {
    leaf.until = until(far);
    return;
  }
  const MotionRate& rate = odometer_->rate();
  const PairCertificates::Split split =
      whole ? certificates_.split(rate) : certificates_.outlasted_by(left(leaf.rest));
  leaf.due = split.due;
  if (whole) leaf.rest = until(split.rest);
  leaf.until = earlier(until(split.first), leaf.rest);
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
  const FrontCell cell = choose_cell(tick, std::min<std::uint64_t>(entries, budget / 2));
  const auto is_held = [&](const auto& entry) { return cell.holds(whole_nodes(entry.nodes)); };
  std::erase_if(front_.pairs, is_held);
  std::erase_if(front_.leaves, is_held);
  std::erase_if(postponed_, [&](const NodePair& pair) { return cell.holds(whole_nodes(pair)); });
  open_.assign(1, cell.root);
  std::size_t left = std::min<std::uint64_t>(2 * entries, budget);
  while (left > 0 && !open_.empty() && has_room_for_batch()) {
    const std::size_t count = settle_last(tick, left, false);
    left -= count;
    work_.rebuilt += count;
  }
  postponed_.insert(postponed_.end(), open_.begin(), open_.end());
}

// Around an entry that is chosen as if by chance, so that most are where most entries are. It holds at most
// so many, and is looked for as far above as such cells were lately.
FrontCell KineticFront::choose_cell(const Tick& tick, std::size_t most) {
  constexpr std::uint32_t kGoldenRatio = 0x9e3779b9;  // of 2³²: its multiples spread evenly
  const std::uint32_t chance = ticks_ / kRenewalTicks * kGoldenRatio;
  const NodePair chosen = front_.nodes(static_cast<std::size_t>(std::uint64_t{chance} * front_.size() >> 32));
  CellsAbove cells(tick.node_batch, tick.tree_a, tick.tree_b, whole_nodes(chosen), renewed_levels_);
  for (const Entry& entry : front_.pairs) cells.count(whole_nodes(entry.nodes));
  for (const Leaf& leaf : front_.leaves) cells.count(whole_nodes(leaf.nodes));
  const std::size_t up = cells.highest_of(most);
  if (up + 1 == cells.levels()) {
    renewed_levels_ = std::min(renewed_levels_ + 1, CellsAbove::kMostLevels);
  } else if (up + 3 < cells.levels()) {
    --renewed_levels_;
  }
  return cells[up];
}

void KineticFront::rebase() {
  const auto set_back = [this](Until& until) {
    until.distance = rounded_down(until.distance - odometer_->distance());
    until.angle = rounded_down(until.angle - odometer_->angle());
  };
  for (Entry& entry : front_.pairs) set_back(entry.until);
  for (Leaf& leaf : front_.leaves) {
    set_back(leaf.until);
    set_back(leaf.rest);
  }
  odometer_->reset();
}

KineticFront::Until KineticFront::now() const {
  return {rounded_up(odometer_->distance()), rounded_up(odometer_->angle())};
}

KineticFront::Until KineticFront::until(const Certificate& certificate) const {
  if (!certificate.holds()) return kPassed;
  return {rounded_down(odometer_->distance() + kKept * certificate.distance),
          rounded_down(odometer_->angle() + kKept * certificate.angle)};
}

// What is left of a certificate.
Certificate KineticFront::left(const Until& until) const {
  return {until.distance - odometer_->distance(), until.angle - odometer_->angle()};
}

}  // namespace palpate
