#pragma once

#include <optional>

#include "engine/descent/lmd_tracker.h"
#include "engine/snch/kinetic_front.h"
#include "engine/snch/lmd_search.h"

namespace palpate {

// How the LMDs of a pair are found in each step.
enum class SearchMode {
  kGlobal,     // the complete set, searched from scratch
  kDescent,    // local descent from the last search, which is repeated every few steps: may miss
  kCertified,  // the complete set, kept up to date by a kinetic front
};

// What a pair is searched for. The parallel tolerance is not here: PairSearch chooses it.
struct PairSituation {
  Pose body_from_tool;
  double cutoff = 0.0;  // metres
  std::size_t max_overlaps = 0;
  SearchMode mode = SearchMode::kGlobal;
  unsigned global_every = 10;                      // steps from one search to the next while descending
  std::uint64_t budget = KineticFront::kNoBudget;  // tests of a certified step, which descent then completes
};

// Work of one update beyond that of its LmdSet.
struct PairWork {
  std::uint64_t descents = 0;
  std::uint64_t descent_steps = 0;
  std::uint64_t front_entries = 0;
  std::uint64_t front_expired = 0;
  std::uint64_t rebuilds = 0;  // pairs of nodes tested to renew the front
  unsigned age = 0;            // steps since the search that the LMDs come from
  double global_us = 0.0;      // of a search from scratch in this step
};

// The LMDs between one body and the tool, from step to step: looked for again only when the situation has
// changed. After a plateau the next search takes directions for parallel that are a little less so, so that a
// rocking box does not flicker between one and four points.
class PairSearch {
 public:
  // Brings found() up to date; `search` lends its memory.
  void update(const Model& body, const Model& tool, const PairSituation& situation, LmdSearch& search);

  // Whether an update would search, rather than reuse what is found.
  bool needs_search(const PairSituation& situation) const;

  // The pair is out of reach, or one of its models is another.
  void forget();

  const LmdSet& found() const { return found_; }
  bool searched() const { return searched_; }      // by the last update, rather than reused
  bool by_descent() const { return by_descent_; }  // found() is of a budget that ran out: it may miss some
  const PairWork& work() const { return work_; }

 private:
  void search_all(const Model& body, const Model& tool, const SearchOptions& options, LmdSearch& search);
  void descend(const Model& body, const Model& tool, const SearchOptions& options, LmdSearch& search);
  void keep_front(const Model& body, const Model& tool, const SearchOptions& options);
  void finish_by_descent(const Model& body, const Model& tool, const SearchOptions& options);
  void measure_motion(const Model& body, const Model& tool);

  bool known_ = false;  // found_ is complete for situation_
  bool searched_ = false;
  bool by_descent_ = false;
  bool after_plateau_ = false;  // the last complete set had one
  PairSituation situation_;
  LmdSet found_;
  PairWork work_;

  KineticFront front_;  // while certified
  LmdTracker tracker_;  // while descending
  LmdSet last_;         // of the step before, while a front is completed by descent
  LmdSet complete_;
  std::optional<Odometer> odometer_;
  std::optional<unsigned> age_;  // of complete_, in steps
};

}  // namespace palpate
