#include "engine/runtime/global_search.h"

#include <algorithm>

#include "engine/base/clock.h"
#include "engine/runtime/scene_commands.h"

namespace palpate {
namespace {

// A pair that was not near for so many rounds, about a second, gives its memory back.
constexpr std::uint64_t kFarRounds = 1'000;

// A set is the newest from its search's end to the next one's, and old as its search was: two searches, and
// one more for a hand that speeds up.
constexpr double kSearchesAhead = 3.0;

// A search looks at least and at most so much farther than the cutoff, relative to it.
constexpr double kLeastAhead = 0.1;
constexpr double kMostAhead = 2.0;

// A tool that has moved by less than this share of the cutoff since a search is not searched anew: it would
// take a processor for as long as a hand trembles.
constexpr double kTremble = 0.01;

// How much less parallel a plateau may become before it is one no more: as PairSearch has it.
constexpr double kPlateauHysteresis = 4.0;

std::size_t overlap_limit(const SceneOptions& options) {
  return std::clamp<std::size_t>(options.max_overlaps, 1, kMostListed.overlaps);
}

Placement placement_of(const Survey& survey, const Survey::NearBody& body, const Pose& body_from_tool) {
  return {body.model->mesh().frame, survey.tool_model->mesh().frame, body_from_tool};
}

}  // namespace

bool GlobalSearch::run(const Survey& survey) {
  ++round_;
  bool worked = false;
  for (const Survey::NearBody& body : survey.near) {
    Pair& pair = pairs_[body.id];
    pair.near_in = round_;
    worked |= prepare(survey, body, pair);
    if (survey.options.mode == SearchMode::kDescent) {
      worked |= search(survey, body, pair);
    } else {
      pair.searched_cutoff.reset();
    }
  }
  let_go_of_far_pairs();
  return worked;
}

bool GlobalSearch::prepare(const Survey& survey, const Survey::NearBody& body, Pair& pair) {
  if (pair.tool != survey.tool) {
    pair.live = nullptr;
    pair.searched_cutoff.reset();
  }
  const bool outgrown = pair.live && pair.live->grant_room();
  const bool near_minima = survey.options.law == ForceLaw::kSmooth;
  if (pair.live && !outgrown && (pair.near_minima || !near_minima)) return false;
  if (outgrown) {
    pair.room.front *= 2;
    pair.room.minima *= 2;
  }
  const PairSituation situation{inverse(body.pose) * survey.tool_pose,
                                survey.options.cutoff,
                                overlap_limit(survey.options),
                                survey.options.mode,
                                survey.options.global_every,
                                survey.step,
                                near_minima};
  auto command = std::make_unique<ExchangeSearch>(body.id, survey.tool);
  auto live = std::make_shared<LivePair>();
  for (const Model* model : {body.model.get(), survey.tool_model.get()}) {
    static_cast<void>(model->tree());
    if (near_minima) static_cast<void>(model->near_tree());
  }
  if (situation.mode != SearchMode::kGlobal)
    command->search.update(*body.model, *survey.tool_model, situation, search_);
  const Room room = command->search.fix(pair.room, live, near_minima);
  command->springs.reserve(std::max(room.minima, kNearRoom));
  pair.live = std::move(live);
  pair.tool = survey.tool;
  pair.near_minima = near_minima;
  to_servo_.post(command.release());
  preparations_.add(1);
  return true;
}

bool GlobalSearch::search(const Survey& survey, const Survey::NearBody& body, Pair& pair) {
  const Pose body_from_tool = inverse(body.pose) * survey.tool_pose;
  const double cutoff = survey.options.cutoff;
  const double moved = moved_since_search(survey, body, body_from_tool, pair);
  if (pair.searched_cutoff == cutoff && moved <= kTremble * cutoff) return false;
  SearchOptions options;
  options.cutoff = cutoff + std::clamp(kSearchesAhead * moved, kLeastAhead * cutoff, kMostAhead * cutoff);
  options.max_overlaps = overlap_limit(survey.options);
  if (pair.plateau) options.parallel_tolerance *= kPlateauHysteresis;

  const Stopwatch watch;
  SearchService::Searched& draft = pair.live->draft();
  search_.run(*body.model, *survey.tool_model, body_from_tool, options, draft.found);
  draft.radius = options.cutoff;
  draft.step = survey.step;
  draft.search_us = watch.elapsed_us();
  pair.plateau = draft.found.has_plateau();
  pair.searched_cutoff = cutoff;
  pair.searched_at->start(placement_of(survey, body, body_from_tool));
  pair.live->publish();
  searches_.add(1);
  return true;
}

// In metres, at most; none if there was no search.
double GlobalSearch::moved_since_search(const Survey& survey, const Survey::NearBody& body,
                                        const Pose& body_from_tool, Pair& pair) {
  const ModelFrame &to = body.model->mesh().frame, &from = survey.tool_model->mesh().frame;
  if (!pair.searched_at || !pair.searched_cutoff) {
    pair.searched_at.emplace((survey.tool_model->centre() - from.origin) / from.scale,
                             (survey.tool_model->radius() + survey.options.cutoff) / to.scale);
    return 0.0;
  }
  Odometer from_there = *pair.searched_at;
  from_there.advance(placement_of(survey, body, body_from_tool));
  return from_there.rate().distance() * to.scale;
}

void GlobalSearch::let_go_of_far_pairs() {
  for (auto pair = pairs_.begin(); pair != pairs_.end();) {
    if (round_ - pair->second.near_in < kFarRounds) {
      ++pair;
      continue;
    }
    if (pair->second.live) to_servo_.post(new ExchangeSearch(pair->first, pair->second.tool));
    pair = pairs_.erase(pair);
  }
}

}  // namespace palpate
