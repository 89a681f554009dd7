#pragma once

#include <cstdint>
#include <memory>
#include <vector>

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

  PairSearch against_tool;
  PairSprings springs;  // against the tool

 private:
  BodyOptions options_;
  Sphere sphere_;
};

// Bodies in slots whose order never changes. An id is its slot and the slot's generation, so that the id of a
// body that was removed stays invalid.
class BodyTable {
 public:
  static constexpr std::size_t kMaxBodies = 1u << 24;

  BodyId add(Body body);  // 0 if the table is full
  bool remove(BodyId id);
  Body* find(BodyId id);
  const Body* find(BodyId id) const;

  // Calls visit(id, body) for every body in the order of slots.
  template <class Visit>
  void for_each(Visit&& visit) {
    for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
      if (slots_[slot].body) visit(id_of(slot), *slots_[slot].body);
    }
  }

 private:
  struct Slot {
    std::uint32_t generation = 1;
    std::unique_ptr<Body> body;
  };

  BodyId id_of(std::size_t slot) const { return BodyId{slots_[slot].generation} << 32 | slot; }

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
};

}  // namespace palpate
