#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "engine/math/pose.h"
#include "engine/snch/lmd.h"

namespace palpate {

// A spring that may outlive its LMD: one end and the direction are fixed to the body's material, the other
// end to the tool's. Its distance is measured along the direction: negative where the tool is beyond the
// surface.
struct HeldSpring {
  Lmd at;              // frame of the body
  DVec3 tool_point;    // point_b in the frame of the tool
  double share = 1.0;  // of its weight, while it comes or goes
  double moved = 0.0;  // metres that point_b went in the last step

  void move(const Pose& body_from_tool) {
    const DVec3 before = at.point_b;
    at.point_b = body_from_tool * tool_point;
    at.distance = glm::dot(at.normal, at.point_b - at.point_a);
    moved = glm::length(at.point_b - before);
  }

  // Whether the tool can have gone through the surface in the last step.
  bool may_have_crossed() const { return at.distance <= moved; }
};

// What one step is to springs that are held.
struct HoldingStep {
  double cutoff;  // metres
  double share;   // by which what comes or goes changes in this step
  bool overlapping;
};

// A pair holds at most so many walls, and lets so many springs fade at once.
inline constexpr std::size_t kMostHeld = 64;

// Where the range of springs of the set of items[begin] ends. `lmd_of` takes an item to its Lmd.
template <class Items, class LmdOf>
std::size_t end_of_set(const Items& items, std::size_t begin, LmdOf&& lmd_of) {
  std::size_t end = begin + 1;
  while (end < items.size() && lmd_of(items[end]).set == lmd_of(items[begin]).set) ++end;
  return end;
}

// Whether a set that is gone while surfaces overlap is held by a wall.
inline bool becomes_wall(std::span<const HeldSpring> set) {
  return std::any_of(set.begin(), set.end(),
                     [](const HeldSpring& spring) { return spring.may_have_crossed(); });
}

}  // namespace palpate
