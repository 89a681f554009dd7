#include "engine/snch/parallel_cells.h"

#include <algorithm>
#include <cmath>

namespace palpate {
namespace {

// How far corners are drawn towards the middle of their cell, as a part of the way.
constexpr double kInset = 1e-5;

// Cells narrower than this, and parts of cells this near to the border of a face (A's normalised frame), are
// left out: it is the grid of float32 coordinates, on which faces meet by chance.
constexpr double kBorder = 1e-7;

double squared(double x) {
  return x * x;
}

bool are_parallel(const DVec3& one, const DVec3& other, double sine) {
  const DVec3 across = glm::cross(one, other);
  return glm::dot(across, across) <= squared(sine) * glm::dot(one, one) * glm::dot(other, other);
}

bool are_perpendicular(const DVec3& one, const DVec3& other, double cosine) {
  return squared(glm::dot(one, other)) <= squared(cosine) * glm::dot(one, one) * glm::dot(other, other);
}

}  // namespace

void ParallelCells::operator()(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among) {
  if (among.has(FeaturePairSet::kFaces)) test_faces(a, b);
  test_edges_and_face(b_, b, a_, a, among);
  test_edges_and_face(a_, a, b_, b, among);
  test_edge_pairs(a, b, among);
}

void ParallelCells::test_faces(const TestedTriangle& a, const TestedTriangle& b) {
  const DVec3 up = a_.normal(a), normal_b = b_.normal(b);
  if (!are_parallel(up, normal_b, limits_.parallel_tolerance)) return;
  const bool above = glm::dot(b.shape.corner[0] - a.shape.corner[0], up) > 0;
  const DVec3 normal = above ? up : -up;
  if (!above && !a_.mesh.double_sided[a.index]) return;
  if (glm::dot(normal, normal_b) > 0 && !b_.mesh.double_sided[b.index]) return;
  Corners corners;
  for (const DVec3& corner : b.shape.corner) corners.add(corner);
  emit({a_, a_.face(a), b_.face(b), normal, 0.0}, clipped(corners, a.shape, up), a.shape.corner[0]);
}

void ParallelCells::test_edges_and_face(const MeshSide& edge_side, const TestedTriangle& edges,
                                        const MeshSide& face_side, const TestedTriangle& face,
                                        FeaturePairSet among) {
  if (!among.has_any(FeaturePairSet::edge_and_face(edge_side.is_b, 0), 3)) return;
  const DVec3 up = face_side.normal(face);
  for (int side = 0; side < 3; ++side) {
    if (!edges.has_side(side) || !among.has(FeaturePairSet::edge_and_face(edge_side.is_b, side)) ||
        !are_perpendicular(edges.shape.along(side), up, limits_.parallel_tolerance))
      continue;
    const bool above = glm::dot(edges.shape.start(side) - face.shape.corner[0], up) > 0;
    if (!above && !face_side.mesh.double_sided[face.index]) continue;
    const DVec3 normal = above ? up : -up;
    const Feature edge = edge_side.edge(edges, side);
    const double lean = edge_side.violation(edge, -normal);
    if (lean > limits_.parallel_tolerance || !edge_side.outward(edge, -normal)) continue;
    Corners corners;
    corners.add(edges.shape.start(side));
    corners.add(edges.shape.end(side));
    emit({face_side, face_side.face(face), edge, normal, lean}, clipped(corners, face.shape, up),
         face.shape.corner[0]);
  }
}

void ParallelCells::test_edge_pairs(const TestedTriangle& a, const TestedTriangle& b, FeaturePairSet among) {
  for (int i = 0; i < 3; ++i) {
    if (!a.has_side(i)) continue;
    for (int j = 0; j < 3; ++j) {
      if (!b.has_side(j) || !among.has(FeaturePairSet::edges(i, j))) continue;
      const DVec3 u = a.shape.along(i), v = b.shape.along(j);
      if (!are_parallel(u, v, limits_.parallel_tolerance)) continue;
      const double length = glm::length(u);
      const DVec3 along = u / length;
      const double from = glm::dot(b.shape.start(j) - a.shape.start(i), along);
      const double to = glm::dot(b.shape.end(j) - a.shape.start(i), along);
      const double low = std::max(0.0, std::min(from, to)), high = std::min(length, std::max(from, to));
      if (!(high - low > kBorder)) continue;
      const DVec3 between = b.shape.start(j) - a.shape.start(i) - along * from;
      const double distance = glm::length(between);
      if (!(distance > limits_.touch)) continue;
      const DVec3 normal = between / distance;
      const Feature edge_a = a_.edge(a, i), edge_b = b_.edge(b, j);
      const double lean = std::max(a_.violation(edge_a, normal), b_.violation(edge_b, -normal));
      if (lean > limits_.parallel_tolerance || !a_.outward(edge_a, normal) || !b_.outward(edge_b, -normal))
        continue;
      Corners corners;
      for (const double place : {low, high})
        corners.add(b.shape.start(j) + v * ((place - from) / (to - from)));
      emit({a_, edge_a, edge_b, normal, lean}, corners, a.shape.start(i));
    }
  }
}

// The part of a polygon or segment over a triangle (Sutherland & Hodgman 1974).
ParallelCells::Corners ParallelCells::clipped(Corners corners, const Triangle& triangle,
                                              const DVec3& normal) {
  for (int side = 0; side < 3; ++side) {
    const DVec3 inward = glm::cross(normal, triangle.along(side));
    const double border = kBorder * glm::length(inward);
    const auto depth = [&](const DVec3& point) {
      return glm::dot(inward, point - triangle.start(side)) - border;
    };
    Corners kept;
    for (std::size_t i = 0; i < corners.count; ++i) {
      const DVec3 &from = corners.point[i], &to = corners.point[(i + 1) % corners.count];
      const double start = depth(from), end = depth(to);
      if (start >= 0) kept.add(from);
      if ((start < 0) != (end < 0) && !(corners.count == 2 && i == 1))
        kept.add(from + (to - from) * (start / (start - end)));
    }
    corners = kept;
  }
  return corners;
}

// The length of a segment, or twice the area of a polygon over its longest side: about its width.
double ParallelCells::width_of(const Corners& corners, const DVec3& normal) {
  if (corners.count < 2) return 0.0;
  double longest = 0.0, area = 0.0;
  for (std::size_t i = 0; i < corners.count; ++i) {
    const DVec3 from = corners.point[i] - corners.point[0],
                to = corners.point[(i + 1) % corners.count] - corners.point[0];
    longest = std::max(longest, glm::length(to - from));
    area += glm::dot(glm::cross(from, to), normal);
  }
  return corners.count == 2 ? longest : std::abs(area) / longest;
}

void ParallelCells::emit(const Cell& cell, const Corners& corners, const DVec3& on_first) {
  if (width_of(corners, cell.normal) < kBorder) return;
  DVec3 middle(0.0);
  for (std::size_t i = 0; i < corners.count; ++i)
    middle += corners.point[i] / static_cast<double>(corners.count);
  const bool swapped = cell.first.is_b;
  for (std::size_t i = 0; i < corners.count; ++i) {
    const DVec3 second = corners.point[i] + kInset * (middle - corners.point[i]);
    const double distance = glm::dot(second - on_first, cell.normal);
    if (distance > limits_.cutoff || distance <= limits_.touch) continue;
    const DVec3 first = second - cell.normal * distance;
    found_.push_back({swapped ? cell.second_feature : cell.first_feature,
                      swapped ? cell.first_feature : cell.second_feature, swapped ? second : first,
                      swapped ? first : second, swapped ? -cell.normal : cell.normal, distance,
                      cell.violation, false, true});
  }
}

}  // namespace palpate
