#pragma once

#include "engine/base/result.h"
#include "engine/scene/body_table.h"
#include "engine/scene/executor.h"
#include "engine/scene/law_springs.h"
#include "engine/scene/spring_forces.h"
#include "engine/scene/tool_reach.h"

namespace palpate {

struct SceneOptions {
  double cutoff = 0.0;        // metres, positive
  double stiffness = 1000.0;  // N/m, not negative
  std::size_t max_overlaps = 1024;
  SearchMode mode = SearchMode::kCertified;
  unsigned global_every = 10;  // steps, positive
  double damping = 0.0;        // N·s/m along a spring while it closes
  double stiffness_cap = 0.0;  // N/m of all springs together; 0: what the device can, negative: none
  double friction = 0.0;       // Coulomb's coefficient
  double fade_time = 0.0;      // seconds
  double time_step = 0.001;    // seconds from one step to the next, positive
  ForceLaw law = ForceLaw::kSmooth;
  unsigned tick_budget = 0;  // tests of pairs in a certified step; 0: no limit
};

// What a step whose memory is fixed lists at most.
inline constexpr Contacts::Most kMostListed{1'024, 4'096, Room{}.overlaps};

// Bodies within reach that it touches at most.
inline constexpr std::size_t kMostNear = 4'096;

// Bodies and the tool that touches them. World frame, metres. Keeps its memory, so that a step like one
// before allocates nothing. One thread at a time.
class Scene {
 public:
  explicit Scene(const SceneOptions& options) : options_(options) {}

  void set_cutoff(double cutoff) { options_.cutoff = cutoff; }
  void set_stiffness(double stiffness) { options_.stiffness = stiffness; }
  void set_damping(double damping) { options_.damping = damping; }
  void set_stiffness_cap(double cap) { options_.stiffness_cap = cap; }
  // What the device that holds the tool can render, N/m at the tool; 0: no device, or one that does not say.
  void set_device_stiffness(double most) { device_stiffness_ = most; }
  double stiffness_cap() const;  // that is in force, the scene's own or the device's; 0 or less: none
  void set_friction(double friction) { options_.friction = friction; }
  void set_law(ForceLaw law) { options_.law = law; }
  void set_mode(SearchMode mode) { options_.mode = mode; }

  // Errors: kInvalidArgument (a second tool), kLimit.
  Result<BodyId> add(BodyOptions options);
  bool remove(BodyId id);  // false: no such body
  const Body* find(BodyId id) const { return bodies_.find(id); }
  BodyId tool() const { return tool_; }        // 0: none
  bool set_pose(BodyId id, const Pose& pose);  // false: no such body

  // For who hands out the ids itself, instead of add() and remove().
  void place(std::unique_ptr<Body> body);
  std::unique_ptr<Body> take(BodyId id);                               // null: no such body
  void move_to(BodyTable::Slots& larger) { bodies_.move_to(larger); }  // their memory is exchanged
  Body* body_against(BodyId tool, BodyId id);  // null: no such body, or the tool is another

  // Fixed, steps allocate nothing: a pair is skipped, and flagged, until it takes a search whose memory is
  // fixed, and what finds no room is cut, and flagged.
  void fix();
  void unfix();

  std::uint64_t steps() const { return steps_; }
  // Who runs the searches of a step; null, as in the beginning: the caller's thread alone. Must live as long
  // as the scene. The outcome does not depend on it.
  void set_executor(Executor* executor);

  // Searches the tool against every body within reach. If it throws, contacts() is what it was.
  void step() { step(options_.time_step); }
  void step(double dt);  // seconds since the last step
  const Contacts& contacts() const { return contacts_; }

  // For whoever records.
  const SceneOptions& options() const { return options_; }
  template <class Visit>
  void for_each_body(Visit&& visit) {
    bodies_.for_each([&](BodyId, Body& body) { visit(body); });
  }
  // From now on the ids of bodies that take() takes are put behind `removed`, while memory is fixed as long
  // as that has room; null: no more.
  void note_removals(std::vector<BodyId>* removed) { removed_ = removed; }

 private:
  // A body within reach of the tool.
  struct NearBody {
    BodyId id;
    Body* body;
    ForceLaw law;
    PairSituation situation;
    std::uint32_t first_set = 0;  // what its set 0 is called among all contacts
  };
  class Searches;

  void lose_tool();
  void note_removal(BodyId id);
  void find_near_bodies(const Body& tool);
  void look_at(BodyId id, Body& body, const Body& tool);
  void share_budget();
  void search_near_bodies(const Body& tool);
  ContactPair contact_pair(const NearBody& near, const Body& tool) const;
  void list(NearBody& near, const Body& tool);
  void make_room_for_springs();
  void push(const NearBody& near, const Body& tool);
  SpringLaw spring_law_of(const BodyOptions& body) const;
  std::size_t max_overlaps() const;

  SceneOptions options_;
  double device_stiffness_ = 0.0;
  bool fixed_ = false;
  std::uint64_t steps_ = 0;
  double time_step_ = 0.0;
  BodyTable bodies_;
  ToolReach reach_;
  BodyId tool_ = 0;
  std::vector<BodyId>* removed_ = nullptr;
  Executor* executor_ = nullptr;
  std::vector<LmdSearch> searches_ = std::vector<LmdSearch>(1);  // by worker
  std::vector<NearBody> near_;                                   // in the order of slots
  LawSprings law_springs_;
  SpringForces forces_;
  std::size_t spring_room_ = 0;  // of both, and of the contacts
  Contacts contacts_;
  Contacts next_;
};

}  // namespace palpate
