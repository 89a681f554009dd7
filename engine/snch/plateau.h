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
  static constexpr std::size_t kMaxPoints = 8;  // of a plateau

  // Replaces `found.lmds` and `found.set_count`; points and `touch`, the distance that counts as touching,
  // are in A's normalised frame. Reorders `minima`.
  void group(const Mesh& a, const Mesh& b, double touch, std::vector<Minimum>& minima, LmdSet& found);

  // Allocates nothing for so many minima any more; fix(0): it may again.
  void fix(std::size_t minima);

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
  static double turn(const PlanePoint& from, const PlanePoint& middle, const PlanePoint& to);
  static double extent_of(const std::vector<PlanePoint>& points);
  static double distance_to_segment(const PlanePoint& point, const PlanePoint& from, const PlanePoint& to);

  void link_by_triangle_pairs(const Mesh& a, const Mesh& b, const std::vector<Minimum>& minima);
  void link_hub(const Mesh& a, const Mesh& b, const std::vector<Minimum>& minima, std::uint32_t hub);
  void unite(std::uint32_t one, std::uint32_t other);
  std::uint32_t root_of(std::uint32_t minimum);
  void sort_into_groups();
  void emit_group(const std::uint32_t* begin, const std::uint32_t* end, const std::vector<Minimum>& minima,
                  double touch, LmdSet& found);
  void project(const std::uint32_t* begin, const std::uint32_t* end, const std::vector<Minimum>& minima);
  void find_hull(double merge);
  void wrap_points();
  double distance_outside(const PlanePoint& point) const;
  void straighten_hull(double merge);
  PlanePoint middle_of_rim() const;
  void thin_hull();
  void weigh_hull(const PlanePoint& middle);

  bool fixed_ = false;
  std::vector<std::uint32_t> parents_;
  std::vector<PairKey> keys_;
  std::vector<std::uint32_t> hubs_;  // minima on many pairs of triangles
  std::vector<std::uint32_t> grouped_;
  std::vector<PlanePoint> points_;
  std::vector<PlanePoint> inset_points_;
  std::vector<PlanePoint> hull_;
  std::vector<double> weights_;  // of the hull's corners
};

}  // namespace palpate
