#pragma once

#include <vector>

#include "tests/stress/families.h"

namespace palpate::stress {

// What one method made of distances of triangles.
struct TriangleTally {
  long pairs = 0;
  long wrong = 0;           // by more than 1e-6 of the size of the smaller triangle, or not a number
  long false_contacts = 0;  // said to touch, and do not
  long false_gaps = 0;      // cross, and are said not to touch
  std::vector<double> errors;

  void add(const TriangleTally& other);
};

struct TriangleOutcome {
  TriangleTally palpate;
  TriangleTally fcl;         // double precision
  TriangleTally fcl_single;  // single precision
  long unsafe_bounds = 0;    // of the wide kernel: more than the true distance

  void add(const TriangleOutcome& other);
};

// Measures pairs of triangles of a case, near ones first, against the exact distance.
TriangleOutcome stress_triangles(const Case& c, Random& random);

}  // namespace palpate::stress
