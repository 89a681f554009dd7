#pragma once

#include <cstdint>
#include <vector>

#include "engine/snch/lmd.h"
#include "engine/snch/minimum.h"

namespace palpate {

// Turns minima into local minimum distances: those of one plateau become one set of at most eight weighted
// extreme points. Keeps its memory from call to call.
//
// Two minima on one pair of triangles belong to one plateau: squared distance is convex on the product of two
// triangles. Plateaus are connected through shared pairs. Force and cost do not depend on how finely a
// plateau is tessellated: its points are corners of its convex hull, weighted by half the length of the
// hull's sides beside them.
class PlateauGrouper {
 public:
  struct Limits {
    double touch;               // A's normalised frame
    double parallel_tolerance;  // radians
  };

  // Replaces `found.lmds` and `found.set_count`; points are in A's normalised frame. Reorders `minima`.
  void group(const Mesh& a, const Mesh& b, const Limits& limits, std::vector<Minimum>& minima, LmdSet& found);

 private:
  struct PairKey {
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t minimum;

    friend auto operator<=>(const PairKey&, const PairKey&) = default;
  };
  struct PlanePoint {
    double x;
    double y;
    std::uint32_t minimum;
  };

  static double distance_between(const PlanePoint& one, const PlanePoint& other);
  static double distance_to_segment(const PlanePoint& point, const PlanePoint& from, const PlanePoint& to);

  void link_by_triangle_pairs(const Mesh& a, const Mesh& b, const std::vector<Minimum>& minima);
  std::uint32_t root_of(std::uint32_t minimum);
  void sort_into_groups();
  void emit_group(const std::uint32_t* begin, const std::uint32_t* end, const std::vector<Minimum>& minima,
                  const Limits& limits, LmdSet& found);
  void find_hull(const std::uint32_t* begin, const std::uint32_t* end, const std::vector<Minimum>& minima);
  void straighten_hull(double merge);
  void thin_hull();

  std::vector<std::uint32_t> parents_;
  std::vector<PairKey> keys_;
  std::vector<std::uint32_t> grouped_;
  std::vector<PlanePoint> points_;
  std::vector<PlanePoint> hull_;
};

}  // namespace palpate
