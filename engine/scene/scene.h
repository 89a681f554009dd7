#pragma once

#include "engine/base/result.h"
#include "engine/scene/body_table.h"
#include "engine/scene/executor.h"

namespace palpate {

struct SceneOptions {
  double cutoff = 0.0;        // metres, positive
  double stiffness = 1000.0;  // N/m, not negative
  std::size_t max_overlaps = 1024;
  SearchMode mode = SearchMode::kCertified;
  unsigned global_every = 10;  // steps, positive
  unsigned tick_budget = 0;    // tests of pairs in a certified step; 0: no limit
};

// Bodies and the tool that touches them. World frame, metres. Keeps its memory, so that a step like one
// before allocates nothing. One thread at a time.
class Scene {
 public:
  explicit Scene(const SceneOptions& options) : options_(options) {}

  void set_cutoff(double cutoff) { options_.cutoff = cutoff; }
  void set_stiffness(double stiffness) { options_.stiffness = stiffness; }

  void set_mode(SearchMode mode) { options_.mode = mode; }

  // Errors: kInvalidArgument (a second tool), kLimit.
  Result<BodyId> add(BodyOptions options);
  bool remove(BodyId id);  // false: no such body
  const Body* find(BodyId id) const { return bodies_.find(id); }
  bool set_pose(BodyId id, const Pose& pose);  // false: no such body

  // Who runs the searches of a step; null, as in the beginning: the caller's thread alone. Must live as long
  // as the scene. The outcome does not depend on it.
  void set_executor(Executor* executor);

  // Searches the tool against every body within reach. If it throws, contacts() is what it was.
  void step();
  const Contacts& contacts() const { return contacts_; }

 private:
  void forget_searches();
  // A body within reach of the tool.
  struct NearBody {
    BodyId id;
    Body* body;
    PairSituation situation;
  };
  class Searches;

  void find_near_bodies(const Body& tool);
  void share_budget();
  void search_near_bodies(const Body& tool);
  void collect(const NearBody& near, const Body& tool);

  SceneOptions options_;
  BodyTable bodies_;
  BodyId tool_ = 0;
  Executor* executor_ = nullptr;
  std::vector<LmdSearch> searches_ = std::vector<LmdSearch>(1);  // by worker
  std::vector<NearBody> near_;                                   // in the order of slots
  Contacts contacts_;
  Contacts next_;
};

}  // namespace palpate
