#pragma once

#include "engine/descent/descent_pair.h"

namespace palpate {

// Moves `point` to another pair of triangles around a corner of each of its own, if one is found that is
// closer. Around a vertex of hundreds of faces these are slivers, which a descent would cross one by one.
// This looks at every so-manyth of them, then more finely about the closest, and so on. It may miss the
// closest of all, where faces are not numbered around their vertex or have several minima: a descent goes on
// from wherever it ends.
void cross_fans(const DescentPair& pair, DescentPoint& point, DescentWork& work);

}  // namespace palpate
