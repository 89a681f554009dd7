#include "engine/snch/lmd.h"

namespace palpate {

void LmdSet::clear() {
  lmds.clear();
  set_count = 0;
  near_minima.clear();
  overlaps.clear();
  overlaps_cut = false;
  work = {};
}

void LmdSet::add_overlap(TrianglePair pair, std::size_t limit) {
  if (overlaps.size() < limit) return overlaps.push_back(pair);
  overlaps_cut = true;
}

void to_metres(const ModelFrame& frame, LmdSet& found) {
  for (std::vector<Lmd>* minima : {&found.lmds, &found.near_minima})
    for (Lmd& lmd : *minima) {
      lmd.point_a = frame.metres(lmd.point_a);
      lmd.point_b = frame.metres(lmd.point_b);
      lmd.distance *= frame.scale;
    }
}

}  // namespace palpate
