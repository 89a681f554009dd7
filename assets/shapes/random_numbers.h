#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "engine/math/vector.h"

namespace palpate::shapes {

// The same numbers on every platform: the standard fixes this engine bit for bit, but none of its
// distributions.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }

  // Uniform on the unit sphere, by rejection from the cube.
  DVec3 direction() {
    for (;;) {
      const double x = between(-1.0, 1.0);
      const double y = between(-1.0, 1.0);
      const double z = between(-1.0, 1.0);
      const double length = std::sqrt(x * x + y * y + z * z);
      if (length > 0.1 && length <= 1.0) return DVec3(x, y, z) / length;
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace palpate::shapes
