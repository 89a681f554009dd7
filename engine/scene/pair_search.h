#pragma once

#include <memory>
#include <optional>

#include "engine/descent/lmd_tracker.h"
#include "engine/descent/near_explorer.h"
#include "engine/snch/kinetic_front.h"
#include "engine/snch/lmd_search.h"

namespace palpate {

// How the LMDs of a pair are found in each step.
enum class SearchMode {
  kGlobal,     // the complete set, searched from scratch
  kDescent,    // local descent from the last search, which is repeated every few steps: may miss
  kCertified,  // the complete set, kept up to date by a kinetic front
};

// Another thread's part in a pair whose search may neither allocate nor block. All functions are wait-free.
class SearchService {
 public:
  // A complete set, searched from scratch.
  struct Searched {
    LmdSet found;
    double radius = 0.0;     // metres: the cutoff, and as far as the models move while the set is the newest
    std::uint64_t step = 0;  // whose pose it was searched at
    double search_us = 0.0;
  };

  virtual ~SearchService() = default;
  virtual const Searched* newest() = 0;  // null: what it was at the last call; valid until the next
  virtual void want_room() = 0;          // asks for a new PairSearch with more room, to be taken
};

// What a pair is searched for. The parallel tolerance is not here: PairSearch chooses it.
struct PairSituation {
  Pose body_from_tool;
  double cutoff = 0.0;  // metres
  std::size_t max_overlaps = 0;
  SearchMode mode = SearchMode::kGlobal;
  unsigned global_every = 10;                      // steps from one search to the next while descending
  std::uint64_t step = 0;                          // counts steps
  bool near_minima = false;                        // ask for them, too
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

  // Fixes the memory of all searches, at least `room` and four times what the last one used. From now on
  // nothing is allocated, complete sets come from `service`, and what finds no room is cut, and flagged.
  // Returns the room that it made.
  Room fix(Room room, std::shared_ptr<SearchService> service, bool near_minima);
  void unfix();
  bool ready() const { return ready_; }  // fixed, and for these models
  bool ready_for_near_minima() const { return near_ready_; }

  // Takes the place of this search with what `prepared` knows and has room for; `prepared` gets the rest.
  void take(PairSearch& prepared);

  // The pair is out of reach but may soon come back.
  void rest() { known_ = plateau_ = false; }

  // One of the models is another, for which this search is not ready.
  void retire();

  const LmdSet& found() const { return found_; }
  bool searched() const { return searched_; }      // by the last update, rather than reused
  bool by_descent() const { return by_descent_; }  // found() is of a budget that ran out: it may miss some
  const PairWork& work() const { return work_; }

 private:
  void change_mode();
  void find(const Model& body, const Model& tool, const SearchOptions& options, LmdSearch& search);
  void drop();
  void search_all(const Model& body, const Model& tool, const SearchOptions& options, LmdSearch& search);
  void descend(const Model& body, const Model& tool, const SearchOptions& options, LmdSearch& search);
  void keep_front(const Model& body, const Model& tool, const SearchOptions& options);
  void follow(const Model& body, const Model& tool, const SearchOptions& options, double cutoff);
  void finish_by_descent(const Model& body, const Model& tool, const SearchOptions& options);
  void adopt(const Model& body, const Model& tool, const SearchService::Searched& searched);
  double search_radius(const Model& body, const SearchOptions& options) const;
  void measure_motion(const Model& body, const Model& tool);

  bool known_ = false;  // found_ is complete for situation_
  bool searched_ = false;
  bool plateau_ = false;     // the last complete set had one
  bool by_descent_ = false;  // found_ is of a budget that ran out
  PairSituation situation_;
  LmdSet found_;
  PairWork work_;

  KineticFront front_;  // while certified
  LmdTracker tracker_;  // while descending
  NearExplorer near_explorer_;
  LmdSet complete_;
  std::optional<Odometer> odometer_;
  std::optional<unsigned> age_;  // of complete_, in steps

  std::shared_ptr<SearchService> service_;  // while fixed
  bool ready_ = false;
  bool near_ready_ = false;
  bool lost_ = false;                // the front outgrew its room: descent until there is more
  LmdSet next_;                      // of the front
  double radius_ = 0.0;              // of the newest set from the service
  std::uint64_t searched_step_ = 0;  // and its step
};

}  // namespace palpate
