#pragma once

#include <span>
#include <vector>

#include "engine/scene/held_spring.h"
#include "engine/scene/spring_match.h"

namespace palpate {

// Springs that are no more but still push, less in every step. While LMDs are followed by descent, one may be
// lost though the surfaces are as near as before: to the hand it goes gradually.
class SpringFade {
 public:
  void reserve() { fading_.reserve(kMostHeld); }
  void forget() { fading_.clear(); }

  // Moves what fades and drops what has faded, is out of the cutoff, or was put elsewhere.
  void advance(const Pose& body_from_tool, const HoldingStep& step);
  void add(const HeldSpring& spring, const HoldingStep& step);
  // Those of the last step that do not go on, nor as a wall.
  void add_lost(std::span<const HeldSpring> last, const SpringMatch& match, const HoldingStep& step);

  std::span<const HeldSpring> list() const { return fading_; }

 private:
  std::vector<HeldSpring> fading_;
};

// Whether a new set of springs pushes so much at once that it must have been there before, unseen.
bool is_late(std::span<const Lmd> set, double moved, double cutoff);

}  // namespace palpate
