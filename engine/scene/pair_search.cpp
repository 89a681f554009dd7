#include "engine/scene/pair_search.h"

#include <algorithm>
#include <utility>

#include "engine/base/clock.h"

namespace palpate {
namespace {

// How much less parallel a plateau may become before it is one no more, relative to how parallel it must be
// to begin.
constexpr double kPlateauHysteresis = 4.0;

bool same(const PairSituation& a, const PairSituation& b) {
  return a.body_from_tool.rotation == b.body_from_tool.rotation &&
         a.body_from_tool.translation == b.body_from_tool.translation && a.cutoff == b.cutoff &&
         a.max_overlaps == b.max_overlaps && a.mode == b.mode && a.near_minima == b.near_minima;
}

}  // namespace

bool PairSearch::needs_search(const PairSituation& situation) const {
  return !known_ || by_descent_ || !same(situation, situation_);
}

void PairSearch::forget() {
  known_ = plateau_ = lost_ = by_descent_ = false;
  front_.forget();
  tracker_.forget();
  odometer_.reset();
  age_.reset();
  complete_.clear();
}

Room PairSearch::fix(Room room, std::shared_ptr<SearchService> service, bool near_minima) {
  const Room used = front_.used();
  room.front = std::max(room.front, 4 * used.front);
  room.minima =
      std::max({room.minima, 4 * used.minima, 4 * tracker_.used_minima(), 4 * complete_.lmds.size()});
  front_.fix(room);
  tracker_.fix(room);
  near_explorer_.fix();
  for (LmdSet* set : {&found_, &complete_, &next_}) set->reserve(room);
  service_ = std::move(service);
  searched_step_ = situation_.step;
  ready_ = true;
  near_ready_ = near_minima;
  return room;
}

void PairSearch::unfix() {
  if (lost_) forget();
  front_.unfix();
  tracker_.unfix();
  near_explorer_.unfix();
  service_.reset();
  ready_ = near_ready_ = false;
}

void PairSearch::retire() {
  forget();
  ready_ = near_ready_ = false;
}

void PairSearch::take(PairSearch& prepared) {
  std::swap(*this, prepared);
  plateau_ = prepared.plateau_;
  searched_ = known_ = false;
}

void PairSearch::update(const Model& body, const Model& tool, const PairSituation& situation,
                        LmdSearch& search) {
  const SearchService::Searched* const news =
      service_ && situation.mode == SearchMode::kDescent ? service_->newest() : nullptr;
  searched_ = news || needs_search(situation);
  work_ = {};
  if (!searched_) return;
  if (known_ && situation.mode != situation_.mode) change_mode();

  SearchOptions options;
  options.cutoff = situation.cutoff;
  options.max_overlaps = situation.max_overlaps;
  options.near_minima = situation.near_minima;
  if (plateau_) options.parallel_tolerance *= kPlateauHysteresis;

  known_ = by_descent_ = false;
  situation_ = situation;
  if (news) adopt(body, tool, *news);
  try {
    find(body, tool, options, search);
  } catch (...) {
    drop();
    throw;
  }
  known_ = true;
  // A part of a set decides nothing: a front whose tolerance changes starts afresh.
  if (!by_descent_) plateau_ = found_.has_plateau();
}

void PairSearch::find(const Model& body, const Model& tool, const SearchOptions& options, LmdSearch& search) {
  switch (situation_.mode) {
    case SearchMode::kGlobal:
      return search_all(body, tool, options, search);
    case SearchMode::kDescent:
      return descend(body, tool, options, search);
    case SearchMode::kCertified:
      return keep_front(body, tool, options);
  }
}

// What a search has left half-done; a front of which a part is missing would miss LMDs for ever. Whether
// there was a plateau stays known, so that the next set is the one that was to be found.
void PairSearch::drop() {
  const bool plateau = plateau_;
  forget();
  plateau_ = plateau;
  found_.clear();
}

// What the other modes know is stale. Yet a service may have nothing new to say of models that stand still.
void PairSearch::change_mode() {
  if (!service_) return forget();
  plateau_ = lost_ = false;
  front_.forget();
}

void PairSearch::search_all(const Model& body, const Model& tool, const SearchOptions& options,
                            LmdSearch& search) {
  const Stopwatch watch;
  search.run(body, tool, situation_.body_from_tool, options, found_);
  work_.global_us = watch.elapsed_us();
}

void PairSearch::keep_front(const Model& body, const Model& tool, const SearchOptions& options) {
  if (!lost_) {
    front_.update(body, tool, situation_.body_from_tool, options, next_, situation_.budget);
    work_.front_entries = front_.work().entries;
    work_.front_expired = front_.work().expired;
    work_.rebuilds = front_.work().rebuilt;
    if (service_ && front_.tight()) service_->want_room();
    lost_ = next_.cut;
    if (!lost_ && front_.complete()) return std::swap(found_, next_);
  } else {
    next_.clear();
  }
  finish_by_descent(body, tool, options);
  by_descent_ = !lost_;
  if (!lost_) return;
  found_.cut = true;
  service_->want_room();
}

// What the front had no budget to find again, or no room for, comes by descent from the LMDs and overlaps of
// the last step. Those it found are followed, too: they stand still, and a plateau found in part is explored.
void PairSearch::finish_by_descent(const Model& body, const Model& tool, const SearchOptions& options) {
  tracker_.forget();
  tracker_.adopt(body.mesh(), tool.mesh(), found_);
  tracker_.adopt(body.mesh(), tool.mesh(), next_);
  tracker_.adopt(found_.overlaps);
  follow(body, tool, options, options.cutoff);
  for (const TrianglePair& pair : next_.overlaps)
    if (std::find(found_.overlaps.begin(), found_.overlaps.end(), pair) == found_.overlaps.end())
      found_.add_overlap(pair, options.max_overlaps);
  std::sort(found_.overlaps.begin(), found_.overlaps.end());
  found_.overlaps_cut |= next_.overlaps_cut;
  found_.work.node_pairs += next_.work.node_pairs;
  found_.work.triangle_pairs += next_.work.triangle_pairs;
  work_.descents = tracker_.work().descents;
  work_.descent_steps = tracker_.work().steps;
}

// Descent meets overlaps only where an LMD ends in one, so that it
// asks for a search, whose overlaps stand until the next one.
void PairSearch::descend(const Model& body, const Model& tool, const SearchOptions& options,
                         LmdSearch& search) {
  measure_motion(body, tool);
  SearchOptions wide = options;
  wide.cutoff = search_radius(body, options);
  age_ = age_ ? *age_ + 1 : situation_.global_every;
  if (service_) {
    age_ = static_cast<unsigned>(situation_.step - searched_step_);
  } else if (*age_ >= situation_.global_every) {
    const Stopwatch watch;
    search.run(body, tool, situation_.body_from_tool, wide, complete_);
    work_.global_us = watch.elapsed_us();
    tracker_.adopt(body.mesh(), tool.mesh(), complete_);
    age_ = 0;
  }
  follow(body, tool, wide, options.cutoff);
  work_.age = *age_;
  if (found_.overlapping() && !service_) age_ = situation_.global_every;
  for (const TrianglePair& pair : complete_.overlaps)
    if (std::find(found_.overlaps.begin(), found_.overlaps.end(), pair) == found_.overlaps.end())
      found_.add_overlap(pair, options.max_overlaps);
  found_.overlaps_cut |= complete_.overlaps_cut;
  work_.descents = tracker_.work().descents;
  work_.descent_steps = tracker_.work().steps;
  if (service_ && (found_.cut || tracker_.tight())) service_->want_room();
}

void PairSearch::follow(const Model& body, const Model& tool, const SearchOptions& options, double cutoff) {
  tracker_.follow(body.mesh(), tool.mesh(), situation_.body_from_tool, options, cutoff, found_);
  if (options.near_minima) near_explorer_.explore(body, tool, situation_.body_from_tool, cutoff, found_);
}

// Farther than the cutoff by the way that the models can go until the next search, so that an LMD is followed
// before its force begins.
double PairSearch::search_radius(const Model& body, const SearchOptions& options) const {
  if (service_) return std::max(options.cutoff, radius_);
  return options.cutoff +
         (situation_.global_every + 1) * odometer_->rate().distance() * body.mesh().frame.scale;
}

void PairSearch::adopt(const Model& body, const Model& tool, const SearchService::Searched& searched) {
  tracker_.adopt(body.mesh(), tool.mesh(), searched.found);
  complete_.overlaps_cut = searched.found.overlaps_cut;
  complete_.overlaps.clear();
  for (const TrianglePair& pair : searched.found.overlaps)
    complete_.add_overlap(pair, situation_.max_overlaps);
  radius_ = searched.radius;
  searched_step_ = searched.step;
  work_.global_us = searched.search_us;
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
