#pragma once

#include <cstddef>

namespace palpate::bench {

// How much a run takes upon itself.
struct Effort {
  bool quick = false;    // about a minute
  bool largest = false;  // also the models of ten million triangles

  int motions() const { return quick ? 1 : 5; }
  int poses() const { return quick ? 100 : 1000; }  // of each motion
};

}  // namespace palpate::bench
