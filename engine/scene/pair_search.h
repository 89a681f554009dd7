#pragma once

#include "engine/snch/lmd_search.h"

namespace palpate {

// What a pair is searched for. The parallel tolerance is not here: PairSearch chooses it.
struct PairSituation {
  Pose body_from_tool;
  double cutoff = 0.0;  // metres
  std::size_t max_overlaps = 0;
};

// The LMDs between one body and the tool, from step to step: searched again only when the situation has
// changed. After a plateau the next search takes directions for parallel that are a little less so, so that a
// rocking box does not flicker between one and four points.
class PairSearch {
 public:
  // Brings found() up to date; `search` lends its memory.
  void update(const Model& body, const Model& tool, const PairSituation& situation, LmdSearch& search);

  // The pair is out of reach, or one of its models is another.
  void forget() { known_ = false; }

  const LmdSet& found() const { return found_; }
  bool searched() const { return searched_; }  // by the last update, rather than reused

 private:
  bool known_ = false;  // found_ is complete for situation_
  bool searched_ = false;
  PairSituation situation_;
  LmdSet found_;
};

}  // namespace palpate
