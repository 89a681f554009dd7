#pragma once

#include <cstddef>

#include "engine/math/cone.h"
#include "engine/snch/point_list.h"

namespace palpate {

struct FarthestPoint {
  std::size_t index;
  float squared;  // of its distance
};

// The farthest from `from` of the points from `first` to before `end`, of which there is one; of several the
// first. Wide; every instruction set gives the same bits.
FarthestPoint farthest_point(const PointList& points, std::size_t first, std::size_t end, const Vec3& from);

// A narrow cone around unit directions, whose sum is given: centred on their mean, then pulled towards the
// farthest one for a few rounds (Bădoiu & Clarkson 2003). Whole where they do not fit into a half-space.
Cone cone_around(const PointList& directions, std::size_t first, std::size_t end, const DVec3& sum);

}  // namespace palpate
