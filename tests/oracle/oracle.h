#pragma once

#include <string>
#include <vector>

#include "engine/math/pose.h"
#include "engine/snch/lmd.h"
#include "tests/oracle/closest.h"

namespace palpate::oracle {

// What must be found, by the definition alone: every pair of triangles within the cutoff is measured. No
// hierarchy, no cones, no descent; only pairs whose bounding spheres are farther apart than the cutoff are
// not measured.
struct Truth {
  std::vector<Closest> certain;  // local minimum distances with a clear margin in every test
  bool overlap = false;
  bool overlap_certain = true;  // false: surfaces so close to touching that rounding decides
};

// Brute force over all pairs of triangles of two surfaces at a pose.
class Oracle {
 public:
  Oracle(const Surface& a, const Surface& b);

  Truth search(const Pose& a_from_b, double cutoff) const;

  // One closest pair of points for every pair of triangles where it satisfies the definition with equality
  // allowed: of a plateau there are many.
  std::vector<Closest> weak_minima(const Pose& a_from_b, double cutoff) const;

  // The ways in which `found` differs from the definition; the truth may have been searched at a larger
  // cutoff.
  struct Verdict {
    int missed = 0;
    int spurious = 0;
    int wrong_overlap = 0;
    std::string first;  // the first difference in words

    void add(int Verdict::*count, const std::string& what);
  };
  Verdict compare(const LmdSet& found, const Truth& truth, const Pose& a_from_b, double cutoff) const;

 private:
  // Nearby triangles in one bounding sphere.
  struct Block {
    DVec3 centre;
    double radius;
    std::vector<TriangleIndex> triangles;
  };
  struct Ball {
    DVec3 centre;
    double radius;
  };
  static std::vector<Ball> balls_of(const Surface& surface);
  static std::vector<Block> blocks_of(const std::vector<Ball>& balls);

  template <class Visit>
  void for_near_pairs(const Pose& a_from_b, double cutoff, const Visit& visit) const;
  bool weak(const Closest& closest, const Pose& a_from_b) const;
  void measure(TriangleIndex in_a, TriangleIndex in_b, const Pose& a_from_b, double cutoff,
               Truth& truth) const;
  bool certain(const Closest& closest, const DVec3& u, const Pose& a_from_b) const;
  bool is_missed(const Closest& wanted, const LmdSet& found) const;
  std::string fault_of(const Lmd& lmd, const Pose& a_from_b, double cutoff) const;

  const Surface& a_;
  const Surface& b_;
  std::vector<Ball> balls_a_;
  std::vector<Ball> balls_b_;
  std::vector<Block> blocks_a_;
  std::vector<Block> blocks_b_;
  double diagonal_;
};

}  // namespace palpate::oracle
