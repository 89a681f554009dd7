#pragma once

#include "engine/base/result.h"
#include "engine/scene/body_table.h"

namespace palpate {

struct SceneOptions {
  double cutoff = 0.0;        // metres, positive
  double stiffness = 1000.0;  // N/m, not negative
  std::size_t max_overlaps = 1024;
  SearchMode mode = SearchMode::kCertified;
  unsigned global_every = 10;  // steps, positive
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
  BodyId tool() const { return tool_; }        // 0: none
  bool set_pose(BodyId id, const Pose& pose);  // false: no such body

  // Searches the tool against every body within reach. If it throws, contacts() is what it was.
  void step();
  const Contacts& contacts() const { return contacts_; }

 private:
  void forget_searches();
  void touch(BodyId id, Body& body, const Body& tool);

  SceneOptions options_;
  BodyTable bodies_;
  BodyId tool_ = 0;
  LmdSearch search_;
  Contacts contacts_;
  Contacts next_;
};

}  // namespace palpate
