#pragma once

#include <string>
#include <vector>

namespace palpate {

// Of KHR_physics_rigid_bodies. A collider takes part in systems; another may name those that it touches, or
// those that it does not.
struct CollisionFilter {
  std::vector<std::string> systems;  // sorted, as all three
  std::vector<std::string> touched;  // empty: all
  std::vector<std::string> untouched;
};

// By one or both of them two colliders never touch. Where a filter says nothing, they do.
bool never_touch(const CollisionFilter& a, const CollisionFilter& b);

}  // namespace palpate
