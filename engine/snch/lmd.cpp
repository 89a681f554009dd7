#include "engine/snch/lmd.h"

namespace palpate {

void LmdSet::clear() {
  lmds.clear();
  set_count = 0;
  overlaps.clear();
  overlaps_cut = false;
  work = {};
}

}  // namespace palpate
