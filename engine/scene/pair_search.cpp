#include "engine/scene/pair_search.h"

#include <algorithm>

#include "engine/base/clock.h"

namespace palpate {
namespace {

// How much less parallel a plateau may become before it is one no more, relative to how parallel it must be
// to begin.
constexpr double kPlateauHysteresis = 4.0;

bool same(const PairSituation& a, const PairSituation& b) {
  return a.body_from_tool.rotation == b.body_from_tool.rotation &&
         a.body_from_tool.translation == b.body_from_tool.translation && a.cutoff == b.cutoff &&
         a.max_overlaps == b.max_overlaps && a.mode == b.mode;
}

void sort_overlaps(std::size_t most, LmdSet& found) {
  std::vector<TrianglePair>& overlaps = found.overlaps;
  std::sort(overlaps.begin(), overlaps.end());
  overlaps.erase(std::unique(overlaps.begin(), overlaps.end()), overlaps.end());
  found.overlaps_cut |= overlaps.size() > most;
  overlaps.resize(std::min(overlaps.size(), most));
}

}  // namespace

bool PairSearch::needs_search(const PairSituation& situation) const {
  return !known_ || by_descent_ || !same(situation, situation_);
}

void PairSearch::forget() {
  known_ = by_descent_ = after_plateau_ = false;
  front_.forget();
  tracker_.forget();
  odometer_.reset();
  age_.reset();
  complete_.clear();
}

void PairSearch::update(const Model& body, const Model& tool, const PairSituation& situation,
                        LmdSearch& search) {
  searched_ = needs_search(situation);
  work_ = {};
  if (!searched_) return;
  if (known_ && situation.mode != situation_.mode) forget();

  SearchOptions options;
  options.cutoff = situation.cutoff;
  options.max_overlaps = situation.max_overlaps;
  if (after_plateau_) options.parallel_tolerance *= kPlateauHysteresis;

  known_ = false;  // should the search throw, nothing half-done is reused
  by_descent_ = false;
  situation_ = situation;
  switch (situation.mode) {
    case SearchMode::kGlobal:
      search_all(body, tool, options, search);
      break;
    case SearchMode::kDescent:
      descend(body, tool, options, search);
      break;
    case SearchMode::kCertified:
      keep_front(body, tool, options);
      break;
  }
  known_ = true;
  // A part of a set decides nothing: a front whose tolerance changes starts afresh.
  if (!by_descent_) after_plateau_ = found_.has_plateau();
}

void PairSearch::search_all(const Model& body, const Model& tool, const SearchOptions& options,
                            LmdSearch& search) {
  const Stopwatch watch;
  search.run(body, tool, situation_.body_from_tool, options, found_);
  work_.global_us = watch.elapsed_us();
}

void PairSearch::keep_front(const Model& body, const Model& tool, const SearchOptions& options) {
  std::swap(last_, found_);
  front_.update(body, tool, situation_.body_from_tool, options, found_, situation_.budget);
  work_.front_entries = front_.work().entries;
  work_.front_expired = front_.work().expired;
  work_.rebuilds = front_.work().rebuilt;
  by_descent_ = !front_.complete();
  if (by_descent_) finish_by_descent(body, tool, options);
}

// What the front had no budget to find again comes by descent from the LMDs and overlaps of the last step.
// Those it found are followed, too: they stand still, and a plateau found in part is explored.
void PairSearch::finish_by_descent(const Model& body, const Model& tool, const SearchOptions& options) {
  tracker_.forget();
  tracker_.adopt(body.mesh(), tool.mesh(), last_);
  tracker_.adopt(body.mesh(), tool.mesh(), found_);
  tracker_.adopt(last_.overlaps);
  std::swap(last_, found_);
  tracker_.follow(body.mesh(), tool.mesh(), situation_.body_from_tool, options, options.cutoff, found_);
  found_.overlaps.insert(found_.overlaps.end(), last_.overlaps.begin(), last_.overlaps.end());
  sort_overlaps(options.max_overlaps, found_);
  found_.overlaps_cut |= last_.overlaps_cut;
  found_.work.node_pairs += last_.work.node_pairs;
  found_.work.triangle_pairs += last_.work.triangle_pairs;
  work_.descents = tracker_.work().descents;
  work_.descent_steps = tracker_.work().steps;
}

// Descent meets overlaps only where an LMD ends in one, so that it
// asks for a search, whose overlaps stand until the next one.
// The search looks farther than the cutoff by the way that the models can go until the next one, so that an
// LMD is followed before its force begins.
void PairSearch::descend(const Model& body, const Model& tool, const SearchOptions& options,
                         LmdSearch& search) {
  measure_motion(body, tool);
  SearchOptions wide = options;
  wide.cutoff += (situation_.global_every + 1) * odometer_->rate().distance * body.mesh().frame.scale;
  age_ = age_ ? *age_ + 1 : situation_.global_every;
  if (*age_ >= situation_.global_every) {
    const Stopwatch watch;
    search.run(body, tool, situation_.body_from_tool, wide, complete_);
    work_.global_us = watch.elapsed_us();
    tracker_.adopt(body.mesh(), tool.mesh(), complete_);
    age_ = 0;
  }
  tracker_.follow(body.mesh(), tool.mesh(), situation_.body_from_tool, wide, options.cutoff, found_);
  work_.age = *age_;
  if (found_.overlapping()) age_ = situation_.global_every;
  for (const TrianglePair& pair : complete_.overlaps)
    if (std::find(found_.overlaps.begin(), found_.overlaps.end(), pair) == found_.overlaps.end())
      found_.add_overlap(pair, options.max_overlaps);
  found_.overlaps_cut |= complete_.overlaps_cut;
  work_.descents = tracker_.work().descents;
  work_.descent_steps = tracker_.work().steps;
}

void PairSearch::measure_motion(const Model& body, const Model& tool) {
  const ModelFrame &to = body.mesh().frame, &from = tool.mesh().frame;
  const Placement placement(to, from, situation_.body_from_tool);
  if (odometer_) return odometer_->advance(placement);
  odometer_.emplace((tool.centre() - from.origin) / from.scale,
                    (tool.radius() + situation_.cutoff) / to.scale);
  odometer_->start(placement);
}

}  // namespace palpate
