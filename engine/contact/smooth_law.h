#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/vector.h"

namespace palpate {

// A pair of features that holds a local minimum distance or almost does, as the smooth law sees it.
struct NearContact {
  DVec3 point_a;
  DVec3 point_b;
  DVec3 direction;  // unit vector from point_a to point_b
  double distance;  // metres
  double weight;    // 0 to 1, continuous in the pose
};

// Shares one spring among near contacts that hand over to each other, so that the force is continuous in the
// pose and does not depend on tessellation. A contact by itself keeps its whole weight; of several at one
// place with one direction, all together push like one. A contact far from the others or of another direction
// shares with none: one in a groove keeps both walls.
//
// Ours: a partition of unity over feature pairs instead of [JW04] section 3.5, where a spring jumps as its
// LMD comes and goes.
class SmoothLaw {
 public:
  void reserve(std::size_t contacts);

  // The factor of each contact's spring, which stands for the weight in spring_force. Contacts are those of
  // one pair of bodies. The result is valid until the next call. Allocates nothing for as many contacts as
  // before.
  std::span<const double> share(std::span<const NearContact> contacts, double cutoff);

 private:
  void sort_along_x(std::span<const NearContact> contacts);

  std::vector<std::uint32_t> order_;
  std::vector<double> sums_;
  std::vector<double> factors_;
};

}  // namespace palpate
