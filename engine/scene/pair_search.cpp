#include "engine/scene/pair_search.h"

namespace palpate {
namespace {

// How much less parallel a plateau may become before it is one no more, relative to how parallel it must be
// to begin.
constexpr double kPlateauHysteresis = 4.0;

bool same(const PairSituation& a, const PairSituation& b) {
  return a.body_from_tool.rotation == b.body_from_tool.rotation &&
         a.body_from_tool.translation == b.body_from_tool.translation && a.cutoff == b.cutoff &&
         a.max_overlaps == b.max_overlaps;
}

}  // namespace

void PairSearch::update(const Model& body, const Model& tool, const PairSituation& situation,
                        LmdSearch& search) {
  searched_ = !known_ || !same(situation, situation_);
  if (!searched_) return;

  SearchOptions options;
  options.cutoff = situation.cutoff;
  options.max_overlaps = situation.max_overlaps;
  if (known_ && found_.has_plateau()) options.parallel_tolerance *= kPlateauHysteresis;

  known_ = false;  // should the search throw, nothing half-done is reused
  search.run(body, tool, situation.body_from_tool, options, found_);
  situation_ = situation;
  known_ = true;
}

}  // namespace palpate
