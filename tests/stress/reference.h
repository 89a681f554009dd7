#pragma once

#include <string>
#include <vector>

#include "engine/math/pose.h"
#include "engine/snch/lmd.h"
#include "tests/oracle/surface.h"
#include "tests/stress/exact_triangles.h"

namespace palpate::stress {

// How far answers are from the definition.
struct Verdict {
  int missed = 0;
  int spurious = 0;
  int wrong_overlap = 0;
  int undecided = 0;  // weak minima so near to a border that rounding may decide
  int certain = 0;    // minima that must be found
  int not_numbers = 0;
  std::vector<double> errors;  // of distances, relative to the size of the features
  std::string first;           // the first fault in words

  void add(const Verdict& other);
};

// Two meshes at a pose, in 113 bits: the definition of local minimum distances by brute force over all pairs
// of triangles, from the same float32 coordinates and the same double pose that the engine has. Positions are
// in A's normalised frame.
class Reference {
 public:
  Reference(const Mesh& a, const Mesh& b, const Pose& a_from_b, double cutoff);

  // `tolerance` is that of directions, radians; `complete`: all that must be found is looked for.
  Verdict judge(const LmdSet& found, double tolerance, bool complete) const;

  bool overlap() const { return overlap_; }

 private:
  // One model's vertices in A's frame.
  struct Side {
    oracle::Surface surface;
    std::vector<RVec3> vertices;
    std::vector<RVec3> normals;
    std::vector<DVec3> centres;  // bounding spheres
    std::vector<double> radii;

    ExactTriangle triangle(std::uint32_t t) const;
    Real lean(oracle::Place place, const RVec3& u) const;
    Real slant(oracle::Place place, const RVec3& u) const;  // along an edge, where none may be
    Real outwardness(oracle::Place place, const RVec3& u) const;
    oracle::Place place(std::uint32_t t, int code) const;
    oracle::Place lowest_at(oracle::Place place, const RVec3& point, Real near) const;
    Real distance_to(Feature feature, const RVec3& point) const;
  };
  struct Wanted {
    Real distance;
    RVec3 on_a, on_b;
    oracle::Place place_a, place_b;
    bool certain;
  };

  static Side side_of(const Mesh& mesh);
  void finish(Side& side) const;
  void measure(std::uint32_t in_a, std::uint32_t in_b);
  Real feature_size(oracle::Place place_a, oracle::Place place_b) const;
  bool covered(const Wanted& wanted, const LmdSet& found, double tolerance) const;
  bool has_weak_minimum(oracle::Place place_a, oracle::Place place_b) const;
  std::string fault_of(const Lmd& lmd, double tolerance) const;
  double error_of(const Lmd& lmd) const;
  RVec3 normalised(const DVec3& metres) const;

  Side a_;
  Side b_;
  ModelFrame frame_;
  double cutoff_;    // A's normalised frame, as the next
  double rounding_;  // of B's points, and of points in metres
  std::vector<Wanted> wanted_;
  bool overlap_ = false;
  bool overlap_certain_ = true;
};

}  // namespace palpate::stress
