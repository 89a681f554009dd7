#pragma once

#include "engine/exchange/flag.h"
#include "engine/exchange/triple_slot.h"
#include "engine/scene/pair_search.h"

namespace palpate {

// What the servo and the global search share of a pair.
class LivePair : public SearchService {
 public:
  // The servo's.
  const Searched* newest() override { return searched_.fetch() ? &searched_.front() : nullptr; }
  void want_room() override { wants_room_.raise(); }

  // The global search's.
  Searched& draft() { return searched_.back(); }
  void publish() { searched_.publish(); }
  bool grant_room() { return wants_room_.lower(); }  // whether it was wanted

 private:
  TripleSlot<Searched> searched_;
  Flag wants_room_;
};

}  // namespace palpate
