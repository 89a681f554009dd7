#pragma once

#include "engine/scene/contacts.h"
#include "engine/scene/law_springs.h"
#include "engine/scene/spring_forces.h"
#include "engine/snch/lmd_search.h"

namespace palpate {

struct QueryOptions {
  SpringLaw law{1000.0, 0.0};
  std::size_t max_overlaps = 1024;
  ForceLaw force_law = ForceLaw::kSprings;
  DVec3 reference_point{0.0};  // frame of B: torques are about it
};

// One search of two models from scratch. Keeps its memory from call to call. One thread at a time.
class Query {
 public:
  // `a_from_b` is B's frame in A's. Contacts come in A's frame, the wrench is on B. If it throws, contacts()
  // is empty.
  void run(const Model& a, const Model& b, const Pose& a_from_b, const QueryOptions& options);
  const Contacts& contacts() const { return contacts_; }

 private:
  void search(const Model& a, const Model& b, const Pose& a_from_b, const QueryOptions& options);

  LmdSearch search_;
  LmdSet found_;
  LawSprings law_springs_;
  PairSprings springs_;
  SpringForces forces_;
  Contacts contacts_;
};

}  // namespace palpate
