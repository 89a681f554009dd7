#include "engine/snch/lmd.h"

namespace palpate {

void LmdSet::clear() {
  lmds.clear();
  set_count = 0;
  near_minima.clear();
  overlaps.clear();
  overlaps_cut = false;
  cut = false;
  work = {};
}

void LmdSet::reserve(const Room& room) {
  lmds.reserve(room.minima);
  near_minima.reserve(kNearRoom);
  overlaps.reserve(room.overlaps);
}

void LmdSet::add_overlap(TrianglePair pair, std::size_t limit) {
  if (overlaps.size() < limit) return overlaps.push_back(pair);
  overlaps_cut = true;
}

Lmd in_metres(const ModelFrame& frame, Lmd lmd) {
  lmd.point_a = frame.metres(lmd.point_a);
  lmd.point_b = frame.metres(lmd.point_b);
  lmd.distance *= frame.scale;
  return lmd;
}

void to_metres(const ModelFrame& frame, LmdSet& found) {
  for (Lmd& lmd : found.lmds) lmd = in_metres(frame, lmd);
  for (Lmd& near : found.near_minima) near = in_metres(frame, near);
}

}  // namespace palpate
