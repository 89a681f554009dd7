#pragma once

#include "engine/mesh/creases.h"
#include "engine/snch/feature_pairs.h"
#include "engine/snch/measured_triangle.h"
#include "engine/snch/odometer.h"
#include "engine/snch/pair_certificates.h"

namespace palpate {

// Certifies for how long two triangles will neither touch nor hold a local minimum distance on the pairs of
// the features that take part, each pair by itself. One that holds none has a reason: its points lie outside
// their features or beyond the cutoff, which ends with distance, or the direction between them leans outside
// a polar cone. For a corner over a face that direction is the face's normal and for two edges their common
// normal (pairs of features that are faces of the convolution of A and −B), so that the lean ends with
// rotation alone; for the others with both. With creases the pairs hold no near minimum either, whose polar
// cones are wider by the smoothing angle.
class FeatureCertificate {
 public:
  // `reach` is that of the odometer.
  FeatureCertificate(const Mesh& a, const Mesh& b, const Placement& placement,
                     const FeaturePairTest::Limits& limits, const MotionRate& rate, double reach);

  void include_near_minima(const Creases& a, const Creases& b) { creases_a_ = &a, creases_b_ = &b; }

  // How long the triangles are farther apart than the cutoff, so that no pair of features holds anything.
  // Else fills `certificates` with those of the pairs of features `among` all. With `apart` contact is among
  // them or has a certificate that holds, and some hold no longer than that.
  Certificate operator()(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among, bool apart,
                         PairCertificates& certificates) const;

  // What `u` must turn to hold a minimum at an edge or vertex, or a near one. The end of `u` must also move
  // by this part of its distance.
  double beyond(const MeshSide& side, const Feature& feature, const DVec3& u, bool near) const;

  // The seams of near minima at the sides of a face and at the ends of an edge; 0 where there is none.
  double seam_at_side(const MeshSide& side, const TestedTriangle& t, int k, bool near) const;
  double seam_at_ends(const MeshSide& side, const TestedTriangle& t, int k, double distance, bool near) const;

  // A slack that is measured in the frame of a side.
  Certificate seen_from(const MeshSide& side, double slack) const;

  // It need not be bettered.
  bool is_long(const Certificate& certificate) const { return rate_.lifetime(certificate) >= kLongLived; }

  // Of two certificates the one that is likely to hold longer.
  Certificate better(const Certificate& one, const Certificate& other) const {
    return longer(one, other, rate_);
  }
  bool includes_near_minima() const { return creases_a_ != nullptr; }

 private:
  double distance_apart(const Triangle& a, const Triangle& b) const;
  void corners_and_face(const MeasuredTriangle& corners, const MeasuredTriangle& face, FeaturePairSet among,
                        PairCertificates& to) const;
  void edges(MeasuredTriangle& a, MeasuredTriangle& b, FeaturePairSet among, PairCertificates& to) const;
  Certificate arcs_apart(MeasuredTriangle& a, int i, MeasuredTriangle& b, int j) const;
  Certificate edge_pair(MeasuredTriangle& a, int i, MeasuredTriangle& b, int j, bool near) const;
  Certificate common_normal_leaning(MeasuredTriangle& a, int i, MeasuredTriangle& b, int j,
                                    const DVec3& normal, double sine, bool near) const;
  Certificate across_normal(double slack, double arm, double sine) const;
  void corners_and_edges(const MeasuredTriangle& corners, MeasuredTriangle& edges, FeaturePairSet among,
                         PairCertificates& to) const;
  Certificate corner_and_edge(const MeasuredTriangle& corners, int k, MeasuredTriangle& edges, int j,
                              bool near, bool apart) const;
  Certificate faces(const MeasuredTriangle& a, const MeasuredTriangle& b) const;
  void edges_and_face(MeasuredTriangle& edges, const MeasuredTriangle& face, FeaturePairSet among,
                      PairCertificates& to) const;
  void corners(const MeasuredTriangle& a, const MeasuredTriangle& b, FeaturePairSet among,
               PairCertificates& to) const;

  double beyond_edge(MeasuredTriangle& edges, int k, const DVec3& u, bool near) const;
  // Nearer than this the direction between two points is known less well than to the tolerance.
  double close() const { return kClose * limits_.touch; }
  double lateral(double beyond, double distance) const;
  Certificate leaning_from_corner(const MeshSide& corner_side, double beyond, double distance) const;
  const Creases& creases(const MeshSide& side) const { return side.is_b ? *creases_b_ : *creases_a_; }

  static constexpr double kClose = 1e6;
  static constexpr double kLongLived = 16.0;  // ticks

  const MeshSide a_;
  const MeshSide b_;
  const FeaturePairTest::Limits limits_;
  const MotionRate rate_;
  const double reach_;
  const Creases* creases_a_ = nullptr;  // null: no near minima
  const Creases* creases_b_ = nullptr;
};

}  // namespace palpate
