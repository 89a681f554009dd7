#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/contact/stiffness_cap.h"
#include "engine/scene/contacts.h"
#include "engine/scene/pair_springs.h"

namespace palpate {

// Turns the springs of all pairs into the forces and the wrench on the tool: springs under the common cap on
// their stiffness, then damping, then friction on what both press with. Keeps its memory.
class SpringForces {
 public:
  void clear();
  void reserve(std::size_t springs);

  // Adds the springs of a pair to contacts.springs. `first_set` is what the pair's set 0 is called there;
  // kNoSet: springs are of no set.
  void add(std::span<const PairSpring> springs, const ContactPair& pair, std::uint32_t first_set,
           Contacts& contacts);

  // Gives all their forces and sums the wrench. `stiffness_cap` in N/m, 0 or less for none; `reference` is
  // the point of the torque, world frame.
  void finish(double stiffness_cap, const DVec3& reference, Contacts& contacts);

 private:
  // Beside each of contacts.springs.
  struct Push {
    DVec3 velocity;  // world frame
    SpringLaw law;
  };

  std::vector<Push> pushes_;
  StiffnessCap cap_;
};

}  // namespace palpate
