#include "engine/snch/near_minima.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include "engine/kernel/line_pair.h"

namespace palpate {
namespace {

// Edges that differ less than this (radians) do not cross.
constexpr double kParallel = 1e-9;

DVec3 into_frame_of(const MeshSide& side, const DVec3& point) {
  if (!side.is_b) return point;
  return side.placement.into_b(point - side.placement.translation) / side.placement.ratio;
}

DVec3 vertex_in_a(const MeshSide& side, std::uint32_t vertex) {
  const DVec3 position = side.mesh.position(vertex);
  return side.is_b ? side.placement.point(position) : position;
}

double distance_to_segment(const DVec3& point, const DVec3& from, const DVec3& to) {
  const DVec3 along = to - from;
  const double t = std::clamp(glm::dot(point - from, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(point - from - t * along);
}

// Walks over a flat patch from a point on one of its triangles to the creases within a radius. Where that is
// too far, because the patch is finely cut, looks at the lines around it instead. Only of one that is finely
// cut and has hundreds of lines around it may a crease be missed, beyond what was walked.
class PatchWalk {
 public:
  PatchWalk(const NearPolar& side, std::uint32_t triangle, const DVec3& point)
      : mesh_(side.side().mesh),
        creases_(side.creases()),
        point_(into_frame_of(side.side(), point)),
        scale_(side.side().is_b ? side.side().placement.ratio : 1.0) {
    triangles_[0] = triangle;
  }

  // The distance of the nearest crease, or `radius` if none is nearer.
  double nearest_crease(double radius) {
    nearest_ = radius / scale_;
    for (std::size_t i = 0; i < count_; ++i)
      for (std::uint32_t edge : mesh_.triangle_edges[triangles_[i]]) meet(edge);
    if (too_far_)
      for (const Creases::Border& border : creases_.borders_around(triangles_[0])) meet_line(border.line);
    return nearest_ * scale_;
  }

 private:
  void meet(std::uint32_t edge) {
    const auto [from, to] = mesh_.edges[edge].vertex;
    const double distance = distance_to_segment(point_, mesh_.position(from), mesh_.position(to));
    if (distance >= nearest_) return;
    if (!creases_.is_flat(edge)) {
      nearest_ = distance;
      return;
    }
    for (std::uint32_t triangle : mesh_.edge_triangles[edge]) add(triangle);
  }

  void meet_line(std::uint32_t line) {
    const auto [from, to] = creases_.line_ends[line];
    nearest_ = std::min(nearest_, distance_to_segment(point_, mesh_.position(from), mesh_.position(to)));
  }

  void add(std::uint32_t triangle) {
    const auto end = triangles_.begin() + static_cast<std::ptrdiff_t>(count_);
    if (std::find(triangles_.begin(), end, triangle) != end) return;
    too_far_ = count_ == triangles_.size();
    if (!too_far_) triangles_[count_++] = triangle;
  }

  const Mesh& mesh_;
  const Creases& creases_;
  const DVec3 point_;
  const double scale_;
  double nearest_ = 0.0;
  std::array<std::uint32_t, Creases::kMostWalked> triangles_;
  std::size_t count_ = 1;
  bool too_far_ = false;
};

// Past this end of its edge the point left the edge, if it did.
DVec3 end_passed(const NearPolar& side, std::uint32_t edge, const DVec3& point) {
  const auto [one, other] = side.side().mesh.edges[edge].vertex;
  const DVec3 from = vertex_in_a(side.side(), one), to = vertex_in_a(side.side(), other);
  if (glm::dot(point - from, from - to) > 0.0) return from;
  return glm::dot(point - to, to - from) > 0.0 ? to : point;
}

// The way of a point on a crease line to the line's nearer end; infinite if the line is closed. Not positive:
// the point is past it, on the line of an edge that is nearly parallel to the other.
double way_to_line_end(const NearPolar& side, std::uint32_t edge, const DVec3& point) {
  const DVec3 passed = end_passed(side, edge, point);
  double nearest = HUGE_VAL;
  for (std::uint32_t end : side.creases().line_ends[edge]) {
    if (end == Creases::kNone) continue;
    const DVec3 to_end = vertex_in_a(side.side(), end) - passed;
    const double length = glm::length(to_end);
    nearest = std::min(nearest, length > 0.0 ? length - glm::dot(point - passed, to_end) / length : 0.0);
  }
  return nearest;
}

// How much of a point so far beyond its end, in seams, a feature still holds.
double beyond_end(double seams) {
  return smooth_step(1.0 - seams);
}

// How much a side of a triangle holds a point at `place` (0 to 1) along it. The seam is in its lengths.
double hold_of_side(const NearPolar& side, const TestedTriangle& t, int k, double place, double seam) {
  const TriangleIndices& corners = side.side().mesh.triangles[t.index];
  if (place < 0.0) return side.creases().is_straight(corners[k]) ? beyond_end(-place / seam) : 0.0;
  if (place <= 1.0) return 1.0;
  return side.creases().is_straight(corners[(k + 1) % 3]) ? beyond_end((place - 1.0) / seam) : 0.0;
}

// How much a triangle holds a point at `distance` over it. The seam is around its sides, not their lines:
// beyond the sharp corner of a sliver one is near the line far away.
double hold_of_face(const NearPolar& side, const TestedTriangle& t, const DVec3& normal, const DVec3& point,
                    double distance) {
  double outside = HUGE_VAL, seam = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const DVec3 along = t.shape.along(k);
    const double inside = glm::dot(glm::cross(normal, along), point - t.shape.start(k));  // times the length
    if (inside > 0.0) continue;
    if (!side.creases().is_flat(side.side().mesh.triangle_edges[t.index][k])) return 0.0;
    const DVec3 foot = point - normal * glm::dot(normal, point - t.shape.start(k));
    outside = std::min(outside, distance_to_segment(foot, t.shape.start(k), t.shape.end(k)));
    seam = std::min(seam, NearMinimumTest::seam(glm::length(along), distance));
  }
  return outside < HUGE_VAL ? beyond_end(outside / seam) : 1.0;
}

// One of what several pieces of a patch or line hold, each by its share, so that none takes over at once.
// What one pair of features holds was perhaps found twice.
NearMinimum blended(std::span<const NearMinimum> pieces) {
  NearMinimum whole = pieces.front();
  double shares = 0.0, distance = 0.0, weight = 0.0;
  DVec3 point_a(0.0), point_b(0.0), normal(0.0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const NearMinimum& piece = pieces[i];
    if (i > 0 && piece.feature_a == pieces[i - 1].feature_a && piece.feature_b == pieces[i - 1].feature_b)
      continue;
    const double share = piece.hold * piece.weight;
    shares += share;
    distance += share * piece.distance;
    weight += share * piece.weight;
    point_a += share * piece.point_a;
    point_b += share * piece.point_b;
    normal += share * piece.normal;
  }
  const double length = glm::length(normal);
  if (shares == whole.hold * whole.weight || !(length > 0.0)) return whole;
  whole.distance = distance / shares;
  whole.weight = weight / shares;
  whole.point_a = point_a / shares;
  whole.point_b = point_b / shares;
  whole.normal = normal / length;
  return whole;
}

}  // namespace

struct NearMinimumTest::Candidate {
  const NearPolar& first;
  const NearPolar& second;
  Feature first_feature;
  Feature second_feature;
  DVec3 first_point;
  DVec3 second_point;
  DVec3 normal;  // from first to second
  double distance;
  double hold = 1.0;
  double sine_squared = 1.0;  // of the angle between two edges
};

void NearMinimumTest::operator()(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among) {
  test_corners_and_face(b_, b, a_, a, among);
  test_corners_and_face(a_, a, b_, b, among);
  if (a.near_sides && b.near_sides) test_edges(a, b, among);
  test_corners_and_edges(b_, b, a_, a, among);
  test_corners_and_edges(a_, a, b_, b, among);
  test_corners(a, b, among);
}

void NearMinimumTest::test_corners_and_face(const NearPolar& corner_side, const TestedTriangle& corners,
                                            const NearPolar& face_side, const TestedTriangle& face,
                                            FeaturePairSet among) {
  const bool is_b = corner_side.side().is_b;
  if (!corners.near_corners || !among.has_any(FeaturePairSet::corner_and_face(is_b, 0), 3)) return;
  const MeshSide& side = face_side.side();
  const Triangle& triangle = face.shape;
  const DVec3 normal = side.normal(face);
  for (int k = 0; k < 3; ++k) {
    if (!corners.has_near_corner(k) || !among.has(FeaturePairSet::corner_and_face(is_b, k))) continue;
    const DVec3& corner = corners.shape.corner[k];
    const double height = glm::dot(corner - triangle.corner[0], normal);
    if (!within_limits(std::abs(height))) continue;
    if (height < 0 && !side.mesh.double_sided[face.index]) continue;
    const double hold = hold_of_face(face_side, face, normal, corner, std::abs(height));
    if (!(hold > 0.0)) continue;
    admit({face_side, corner_side, side.face(face), corner_side.side().vertex(corners, k),
           corner - normal * height, corner, height < 0 ? -normal : normal, std::abs(height), hold});
  }
}

void NearMinimumTest::test_edges(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among) {
  for (int i = 0; i < 3; ++i) {
    if (!a.has_near_side(i)) continue;
    for (int j = 0; j < 3; ++j)
      if (b.has_near_side(j) && among.has(FeaturePairSet::edges(i, j))) test_edge_pair(a, i, b, j);
  }
}

void NearMinimumTest::test_edge_pair(const TestedTriangle& a, int i, const TestedTriangle& b, int j) {
  const DVec3 u = a.shape.along(i), v = b.shape.along(j);
  const DVec3 &start_a = a.shape.start(i), &start_b = b.shape.start(j);
  const LinePair lines(start_a, u, start_b, v);
  if (!lines.inclined(u, v, kParallel)) return;
  const DVec3 unit = lines.normal / std::sqrt(lines.normal_squared);
  const double height = glm::dot(start_b - start_a, unit);
  if (!within_limits(std::abs(height))) return;
  const double length_a = glm::length(u), length_b = glm::length(v);
  const double sine = std::sqrt(lines.normal_squared) / (length_a * length_b);
  const double stretched = std::abs(height) / (sine * sine);  // what turns a little here shifts farther there
  const double hold = hold_of_side(a_, a, i, lines.s, seam(length_a, stretched) / length_a) *
                      hold_of_side(b_, b, j, lines.t, seam(length_b, stretched) / length_b);
  if (!(hold > 0.0)) return;
  admit({a_, b_, a_.side().edge(a, i), b_.side().edge(b, j), start_a + lines.s * u, start_b + lines.t * v,
         height < 0 ? -unit : unit, std::abs(height), hold, sine * sine});
}

void NearMinimumTest::test_corners_and_edges(const NearPolar& corner_side, const TestedTriangle& corners,
                                             const NearPolar& edge_side, const TestedTriangle& edges,
                                             FeaturePairSet among) {
  const bool is_b = corner_side.side().is_b;
  if (!corners.near_corners || !among.has_any(FeaturePairSet::corner_and_edge(is_b, 0, 0), 9)) return;
  for (int j = 0; j < 3; ++j) {
    if (!edges.has_near_side(j)) continue;
    for (int k = 0; k < 3; ++k)
      if (corners.has_near_corner(k) && among.has(FeaturePairSet::corner_and_edge(is_b, k, j)))
        test_corner_and_edge(corner_side, corner_side.side().vertex(corners, k), corners.shape.corner[k],
                             edge_side, edges, j);
  }
}

void NearMinimumTest::test_corner_and_edge(const NearPolar& corner_side, Feature vertex, const DVec3& corner,
                                           const NearPolar& edge_side, const TestedTriangle& edges,
                                           int side) {
  const DVec3 along = edges.shape.along(side);
  const double length = glm::length(along);
  const double place = glm::dot(corner - edges.shape.start(side), along) / (length * length);
  const DVec3 foot = edges.shape.start(side) + along * place;
  const DVec3 between = corner - foot;
  const double distance = glm::length(between);
  if (!within_limits(distance)) return;
  const double hold = hold_of_side(edge_side, edges, side, place, seam(length, distance) / length);
  if (!(hold > 0.0)) return;
  admit({edge_side, corner_side, edge_side.side().edge(edges, side), vertex, foot, corner, between / distance,
         distance, hold});
}

void NearMinimumTest::test_corners(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among) {
  for (int i = 0; i < 3; ++i) {
    if (!a.has_near_corner(i)) continue;
    for (int j = 0; j < 3; ++j) {
      if (!b.has_near_corner(j) || !among.has(FeaturePairSet::corners(i, j))) continue;
      const DVec3 between = b.shape.corner[j] - a.shape.corner[i];
      const double distance = glm::length(between);
      if (!within_limits(distance)) continue;
      admit({a_, b_, a_.side().vertex(a, i), b_.side().vertex(b, j), a.shape.corner[i], b.shape.corner[j],
             between / distance, distance});
    }
  }
}

// How far the points are from the ends of their features, in terms of the way after which the feature at the
// end takes over: where edges cross at a small angle, the corner at an end of one leans over the other all
// along.
double NearMinimumTest::way_to_end(const Candidate& c) {
  if (c.first_feature.kind == FeatureKind::kFace)
    return PatchWalk(c.first, c.first_feature.index, c.first_point)
        .nearest_crease(Smoothing::kTangent * c.distance);
  double way = HUGE_VAL;
  if (c.first_feature.kind == FeatureKind::kEdge)
    way = way_to_line_end(c.first, c.first_feature.index, c.first_point);
  if (c.second_feature.kind == FeatureKind::kEdge)
    way = std::min(way, way_to_line_end(c.second, c.second_feature.index, c.second_point));
  return way * c.sine_squared;
}

void NearMinimumTest::admit(const Candidate& c) {
  double weight = c.second.weight(c.second_feature, -c.normal);
  if (weight > 0.0) weight *= c.first.weight(c.first_feature, c.normal);
  if (weight > 0.0) weight *= smooth_step(way_to_end(c) / (Smoothing::kTangent * c.distance));
  if (!(weight > 0.0)) return;
  const bool swapped = c.first.side().is_b;
  found_.push_back(
      {{swapped ? c.second_point : c.first_point, swapped ? c.first_point : c.second_point,
        swapped ? -c.normal : c.normal, c.distance, weight, 0, swapped ? c.second_feature : c.first_feature,
        swapped ? c.first_feature : c.second_feature},
       c.hold});
}

void settle_near_minima(const Creases& a, const Creases& b, std::vector<NearMinimum>& near_minima) {
  const auto place = [&](const Lmd& near) {
    return std::tuple(a.whole(near.feature_a), b.whole(near.feature_b));
  };
  std::sort(near_minima.begin(), near_minima.end(), [&](const NearMinimum& one, const NearMinimum& other) {
    return std::tuple(place(one), one.feature_a, one.feature_b) <
           std::tuple(place(other), other.feature_a, other.feature_b);
  });
  std::uint32_t count = 0;
  for (std::size_t i = 0, end; i < near_minima.size(); i = end) {
    for (end = i + 1; end < near_minima.size() && place(near_minima[end]) == place(near_minima[i]);) ++end;
    near_minima[count] = blended({&near_minima[i], end - i});
    near_minima[count].set = count;
    ++count;
  }
  near_minima.resize(count);
}

}  // namespace palpate
