#pragma once

#include <map>
#include <memory>
#include <optional>

#include "engine/exchange/counter.h"
#include "engine/exchange/mailbox.h"
#include "engine/runtime/live_pair.h"
#include "engine/runtime/survey.h"

namespace palpate {

// What is done beside the servo, [JW04] section 3.6: pairs that come near are made ready, with their trees
// built, their first search done and their memory fixed; while descending, every near pair that moves is
// searched from scratch as often as it can be. Ours also prepares the other modes, because a servo that may
// not allocate can begin no search of its own.
class GlobalSearch {
 public:
  // What is ready is posted to the servo.
  explicit GlobalSearch(Mailbox& to_servo) : to_servo_(to_servo) {}

  // One round over all that is near. False: nothing was to be done.
  bool run(const Survey& survey);

  std::uint64_t preparations() const { return preparations_.value(); }
  std::uint64_t searches() const { return searches_.value(); }

 private:
  struct Pair {
    std::shared_ptr<LivePair> live;
    BodyId tool = 0;
    Room room;
    bool near_minima = false;
    std::uint64_t near_in = 0;              // round
    std::optional<double> searched_cutoff;  // of the last search from scratch
    std::optional<Odometer> searched_at;    // begins there
    bool plateau = false;
  };

  bool prepare(const Survey& survey, const Survey::NearBody& body, Pair& pair);
  bool search(const Survey& survey, const Survey::NearBody& body, Pair& pair);
  static double moved_since_search(const Survey& survey, const Survey::NearBody& body,
                                   const Pose& body_from_tool, Pair& pair);
  void let_go_of_far_pairs();

  Mailbox& to_servo_;
  std::map<BodyId, Pair> pairs_;
  std::uint64_t round_ = 0;
  LmdSearch search_;
  Counter preparations_;
  Counter searches_;
};

}  // namespace palpate
