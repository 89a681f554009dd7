#include "engine/gltf/collision_filter.h"

#include <algorithm>

namespace palpate {
namespace {

bool all_within(const std::vector<std::string>& some, const std::vector<std::string>& all) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

// The extension compares sets; a collider in no system is named by nobody.
bool leaves_out(const CollisionFilter& filter, const CollisionFilter& other) {
  if (other.systems.empty()) return false;
  return (!filter.touched.empty() && !all_within(other.systems, filter.touched)) ||
         all_within(other.systems, filter.untouched);
}

}  // namespace

bool never_touch(const CollisionFilter& a, const CollisionFilter& b) {
  return leaves_out(a, b) || leaves_out(b, a);
}

}  // namespace palpate
