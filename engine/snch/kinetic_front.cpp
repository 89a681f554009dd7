#include "engine/snch/kinetic_front.h"

#include <algorithm>
#include <array>

#include "engine/kernel/triangle_pair.h"
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
  const std::uint64_t renewal = ++ticks_ % kRenewalTicks == 0 ? renewal_budget(budget) : 0;
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
  open_.reserve(front_.capacity() + kOpenRoom);  // all may expire at once
  postponed_.reserve(open_.capacity());
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
  return !fixed_ || (has_room(front_, NodeBatch::kMost) && has_room(open_, NodeBatch::kMost));
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
  ticks_ = 0;
  renewed_levels_ = kFirstLevels;
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
    if (!has_room_for_batch()) tick.found.cut = true;
    const std::size_t count = affordable(tick);
    if (tick.found.cut || count == 0) break;
    settle_last(tick, count, true);
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
std::size_t KineticFront::settle_last(Tick& tick, std::size_t most, bool collect) {
  std::array<NodePair, NodeBatch::kMost> pairs;
  const std::size_t count = std::min({most, open_.size(), pairs.size()});
  std::copy(open_.end() - static_cast<std::ptrdiff_t>(count), open_.end(), pairs.begin());
  open_.resize(open_.size() - count);
  NodeBatch::Certificates certificates;
  tick.node_batch.certify({pairs.data(), count}, odometer_->rate(), tick.reach, certificates);
  for (std::size_t i = 0; i < count; ++i) settle(tick, pairs[i], certificates.of(i), collect);
  return count;
}

// Puts a pair on the front if it can be pruned or holds two triangles; otherwise opens its children.
void KineticFront::settle(Tick& tick, NodePair pair, Certificate certificate, bool collect) {
  ++tick.found.work.node_pairs;
  const Node &a = tick.tree_a.node(pair.a), &b = tick.tree_b.node(pair.b);
  if (!certificate.holds() && !(a.is_leaf() && b.is_leaf())) {
    if (tick.node_batch.opens_first(a, b)) {
      open_.push_back({a.second_child(), pair.b});
      open_.push_back({pair.a + 1, pair.b});
    } else {
      open_.push_back({pair.a, b.second_child()});
      open_.push_back({pair.a, pair.b + 1});
    }
    return;
  }
  if (!certificate.holds()) certificate = test_triangles(tick, a.triangle(), b.triangle(), collect);
  front_.push_back(entry_of(pair, certificate));
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

// Takes a part of the front away and descends there anew, as far as it need be now.
void KineticFront::renew(Tick& tick, std::uint64_t budget) {
  if (front_.empty() || (fixed_ && !has_room(postponed_, kOpenRoom))) return;
  const std::size_t entries = std::max(front_.size() / kRenewedShare, kLeastRenewed);
  const FrontCell cell = choose_cell(tick, std::min<std::uint64_t>(entries, budget / 2));
  std::erase_if(front_, [&](const Entry& entry) { return cell.holds({entry.a, entry.b}); });
  std::erase_if(postponed_, [&](const NodePair& pair) { return cell.holds(pair); });
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
  const Entry& chosen = front_[static_cast<std::size_t>(std::uint64_t{chance} * front_.size() >> 32)];
  CellsAbove cells(tick.node_batch, tick.tree_a, tick.tree_b, {chosen.a, chosen.b}, renewed_levels_);
  for (const Entry& entry : front_) cells.count({entry.a, entry.b});
  const std::size_t up = cells.highest_of(most);
  if (up + 1 == cells.levels()) {
    renewed_levels_ = std::min(renewed_levels_ + 1, CellsAbove::kMostLevels);
  } else if (up + 3 < cells.levels()) {
    --renewed_levels_;
  }
  return cells[up];
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
