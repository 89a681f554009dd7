#pragma once

#include <cstddef>

namespace palpate::bench {

// How much a run takes upon itself.
struct Effort {
  bool quick = false;    // about a minute
  bool largest = false;  // also the models of ten million triangles

  int poses() const { return quick ? 100 : 1000; }
};

}  // namespace palpate::bench
