#pragma once

#include <span>
#include <vector>

#include "engine/scene/held_spring.h"
#include "engine/scene/spring_match.h"

namespace palpate {

// Where surfaces cross there is no LMD to push. The springs that were there before hold on: each stays in its
// direction, fixed to the material of both models, and pushes the more the deeper the tool goes, so that the
// hand feels a wall. A pair that overlaps from its first step on has had no springs and has no wall. Walls do
// not slide over the body: on a curved one the direction is that of the place where the tool went in.
class OverlapWall {
 public:
  void reserve() {
    walls_.reserve(kMostHeld);
    released_.reserve(kMostHeld);
  }
  void forget() { walls_.clear(); }

  // Moves the walls and drops those the tool was put away from.
  void advance(const Pose& body_from_tool, const HoldingStep& step);

  // Lets go of walls: all once nothing overlaps, before that those whose LMD is there again.
  void release(std::span<const Lmd> present, const SpringMatch& match, const HoldingStep& step);

  // Makes walls of springs of the last step that are gone because the tool went through the surface: it was
  // no farther than it moved.
  void hold(std::span<const HeldSpring> last, const SpringMatch& match, const HoldingStep& step);

  std::span<const HeldSpring> list() const { return walls_; }
  std::span<const HeldSpring> released() const { return released_; }  // by the last release()

 private:
  void hold_set(std::span<const HeldSpring> set, const HoldingStep& step);

  std::vector<HeldSpring> walls_;
  std::vector<HeldSpring> released_;
};

}  // namespace palpate
