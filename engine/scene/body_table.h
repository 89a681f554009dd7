#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/body_ids.h"
#include "engine/scene/contacts.h"
#include "engine/scene/pair_search.h"
#include "engine/scene/pair_springs.h"
#include "engine/scene/sphere.h"

namespace palpate {

enum class BodyKind { kStatic, kMoving, kTool };

struct BodyOptions {
  BodyKind kind = BodyKind::kStatic;
  std::shared_ptr<const Model> model;
  Pose pose;                   // world from model
  double stiffness = 0.0;      // N/m against the tool; 0: the scene's
  double damping = 0.0;        // N·s/m against the tool while closing; 0: the scene's
  double friction = 0.0;       // Coulomb's coefficient against the tool; 0: the scene's, negative: none
  DVec3 reference_point{0.0};  // of the tool, model frame: torques are about it
  std::string model_name{};    // for people
  bool intangible = false;     // the tool passes through it
};

// A model that is placed in a scene.
class Body {
 public:
  explicit Body(BodyOptions options);

  const BodyOptions& options() const { return options_; }
  const Mesh& mesh() const { return options_.model->mesh(); }
  const Pose& pose() const { return options_.pose; }
  const Sphere& sphere() const { return sphere_; }  // world frame
  void set_pose(const Pose& pose);

  // The tool is out of reach: of a body that it left before, there is nothing to forget.
  void leave();

  BodyId id = 0;
  bool is_near = false;  // was within reach of the tool in the last step
  bool moved = true;     // was placed anew since whoever records looked last
  PairSearch against_tool;
  PairSprings springs;  // against the tool

 private:
  BodyOptions options_;
  Sphere sphere_;
};

// Bodies in slots whose order never changes.
class BodyTable {
 public:
  struct Slot {
    std::unique_ptr<Body> body;
    double far_until = 0.0;    // on the tool's way: until there the body is out of its reach
    double group_until = 0.0;  // of the first of a group: the least of its bodies' far_until, or less
  };
  using Slots = std::vector<Slot>;

  BodyId add(Body body);  // 0 if the table is full
  bool remove(BodyId id);
  Body* find(BodyId id);
  const Body* find(BodyId id) const;
  bool set_pose(BodyId id, const Pose& pose);  // false: no such body

  // For who hands out the ids itself: neither allocates while the slots have room.
  void place(std::unique_ptr<Body> body);
  std::unique_ptr<Body> take(BodyId id);  // null: no such body

  // Moves to `larger`, whose memory changes places with this table's.
  void move_to(Slots& larger);

  // Calls visit(id, body) for every body in the order of slots.
  template <class Visit>
  void for_each(Visit&& visit) {
    for (const Slot& slot : slots_) {
      if (slot.body) visit(slot.body->id, *slot.body);
    }
  }

  // The same for those that the tool may reach after `way`. The visitor returns until where on the tool's way
  // it will not, 0 where it does. Of a group that is far as a whole one slot is read, and no body, each of
  // which is in a memory of its own.
  template <class Visit>
  void for_each_near(double way, Visit&& visit) {
    for (std::size_t first = 0; first < slots_.size(); first += kGroup)
      if (!(slots_[first].group_until > way))
        slots_[first].group_until = visit_group({slots_.data() + first, group_size(first)}, way, visit);
  }

  void forget_far();  // all may be within reach

  std::size_t size() const { return size_; }  // bodies

 private:
  static constexpr std::size_t kGroup = 64;  // slots

  std::size_t group_size(std::size_t first) const { return std::min(kGroup, slots_.size() - first); }

  template <class Visit>
  static double visit_group(std::span<Slot> group, double way, Visit& visit) {
    double least = std::numeric_limits<double>::infinity();
    for (Slot& slot : group) {
      if (!slot.body) continue;
      if (!(slot.far_until > way)) slot.far_until = visit(slot.body->id, *slot.body);
      least = std::min(least, slot.far_until);
    }
    return least;
  }

  void may_be_near(std::uint32_t slot);

  BodyIds ids_;
  Slots slots_;
  std::size_t size_ = 0;
};

}  // namespace palpate
