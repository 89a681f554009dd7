#pragma once

#include <cstddef>
#include <memory>

#include "engine/math/pose.h"
#include "engine/snch/lmd.h"
#include "engine/snch/model.h"

namespace palpate {

struct SearchOptions {
  double cutoff = 0.0;  // metres
  std::size_t max_overlaps = 1024;
  // Directions this far outside a polar cone still belong to a plateau (radians). A caller that follows a
  // motion widens it while there is a plateau, so that a rocking box does not flicker.
  double parallel_tolerance = 1e-6;
  static constexpr double kWidestTolerance = 1e-5;  // more than this is not asked for
  bool near_minima = false;                         // ask for them, too
};

// Searches two models for all local minimum distances, from scratch. Keeps its memory from call to call, so
// that a search like one before allocates nothing. One thread at a time for each object.
class LmdSearch {
 public:
  LmdSearch();
  ~LmdSearch();
  LmdSearch(LmdSearch&&) noexcept;
  LmdSearch& operator=(LmdSearch&&) noexcept;

  // Fills `found`. `a_from_b` is B's frame in A's, metres.
  void run(const Model& a, const Model& b, const Pose& a_from_b, const SearchOptions& options, LmdSet& found);

  // Allocates nothing any more: what finds no room is cut, and flagged. Needs a `found` with the same room.
  void fix(const Room& room);
  void unfix();

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace palpate
