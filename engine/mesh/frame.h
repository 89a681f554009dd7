#pragma once

#include "engine/math/box.h"
#include "engine/math/vector.h"

namespace palpate {

// The normalised frame of a model: metres = origin + scale · normalised. `scale` is a power of two that
// brings the diagonal into (0.5, 1]; `origin` is chosen per axis so that no bit of a float32 input is lost
// (see frame.cpp).
struct ModelFrame {
  DVec3 origin{0.0};
  double scale = 1.0;

  DVec3 metres(const DVec3& normalised) const { return origin + scale * normalised; }
  Vec3 normalised(const DVec3& metres) const { return Vec3((metres - origin) / scale); }
};

// The frame for vertices within `bounds` (metres). `bounds` must be finite and of positive diagonal.
ModelFrame frame_of(const Box& bounds);

}  // namespace palpate
