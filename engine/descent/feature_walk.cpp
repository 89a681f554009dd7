#include "engine/descent/feature_walk.h"

#include <algorithm>

#include "engine/kernel/line_pair.h"
#include "engine/mesh/area.h"

namespace palpate {
namespace {

// A triangle is crossed in two or three steps. More of them are a way too long for one tick, or a circle.
constexpr int kMostSteps = 3 * kMaxDescentSteps;

// Less than this much of a lean is rounding.
constexpr double kLevel = 1e-12;

bool leads(double along, const DVec3& direction, const DVec3& u) {
  return along > 0 && along * along > kLevel * kLevel * glm::dot(direction, direction) * glm::dot(u, u);
}

int corner_of(const TriangleIndices& triangle, std::uint32_t vertex) {
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}

// Not negative: the foot of `point` in the triangle's plane is on the inner side of side k.
double inside(const Triangle& triangle, const DVec3& area, int k, const DVec3& point) {
  return glm::dot(glm::cross(area, triangle.along(k)), point - triangle.start(k));
}

}  // namespace

FeatureWalk::FeatureWalk(const DescentPair& pair)
    : sides_{MeshSide{pair.a(), pair.placement(), false}, MeshSide{pair.b(), pair.placement(), true}} {}

bool FeatureWalk::settle(Feature& a, Feature& b, DescentWork& work) {
  features_ = {a, b};
  int steps = 0;
  Step outcome = step();
  for (; outcome == Step::kMoved && steps < kMostSteps; ++steps) outcome = step();
  if (outcome != Step::kStands) return false;
  a = features_[0];
  b = features_[1];
  work.steps += steps;
  return true;
}

FeatureWalk::Step FeatureWalk::step() {
  if (!plain(0) || !plain(1)) return Step::kLost;
  const FeatureKind a = features_[0].kind, b = features_[1].kind;
  if (a == FeatureKind::kVertex && b == FeatureKind::kVertex) return on_corners();
  if (a == FeatureKind::kEdge && b == FeatureKind::kEdge) return on_edges();
  const int larger = a < b ? 0 : 1;
  if (features_[1 - larger].kind != FeatureKind::kVertex) return Step::kLost;
  return features_[larger].kind == FeatureKind::kFace ? on_face(larger) : on_edge(larger);
}

FeatureWalk::Step FeatureWalk::move(int side, FeatureKind kind, std::uint32_t index) {
  features_[side] = {kind, index};
  return Step::kMoved;
}

// Closed and single-sided there, so that what is outside is known.
bool FeatureWalk::plain(int side) const {
  const Mesh& mesh = sides_[side].mesh;
  const Feature& feature = features_[side];
  switch (feature.kind) {
    case FeatureKind::kVertex:
      return mesh.vertex_flags[feature.index].outward;
    case FeatureKind::kEdge:
      return mesh.edge_flags[feature.index].outward;
    case FeatureKind::kFace:
      break;
  }
  return !mesh.double_sided[feature.index];
}

DVec3 FeatureWalk::point(int side, std::uint32_t vertex) const {
  const DVec3 own = sides_[side].mesh.position(vertex);
  return side ? sides_[side].placement.point(own) : own;
}

Triangle FeatureWalk::shape(int side, std::uint32_t triangle) const {
  const MeshSide& of = sides_[side];
  return side ? triangle_of(of.mesh, triangle, of.placement) : triangle_of(of.mesh, triangle);
}

// The surface is closed: each edge at the vertex begins there in one of the triangles.
FeatureWalk::Rise FeatureWalk::rise(int side, std::uint32_t vertex, const DVec3& u) const {
  const Mesh& mesh = sides_[side].mesh;
  const DVec3 own_u = sides_[side].own(u), from = mesh.position(vertex);
  Rise rise{0, 0, false};
  double most = 0.0;
  for (std::uint32_t triangle : mesh.vertex_triangles[vertex]) {
    const TriangleIndices& corners = mesh.triangles[triangle];
    const int k = corner_of(corners, vertex);
    const std::uint32_t end = corners[(k + 1) % 3];
    const DVec3 along = mesh.position(end) - from;
    const double up = glm::dot(along, own_u);
    if (up > most && leads(up, along, own_u)) {
      most = up;
      rise = {mesh.triangle_edges[triangle][k], end, true};
    }
  }
  return rise;
}

// `u` is at right angles to the edge.
FeatureWalk::Tilt FeatureWalk::tilt(int side, std::uint32_t edge, const DVec3& u) const {
  const Mesh& mesh = sides_[side].mesh;
  const DVec3 own_u = sides_[side].own(u), from = mesh.position(mesh.edges[edge].vertex[0]);
  Tilt tilt{0, false, false};
  for (std::uint32_t triangle : mesh.edge_triangles[edge]) {
    const TriangleIndices& corners = mesh.triangles[triangle];
    const DVec3 across = mesh.position(apex_of(corners, mesh.edges[edge])) - from;
    if (leads(glm::dot(across, own_u), across, own_u)) tilt.face = triangle, tilt.any = true;
    tilt.outward |= glm::dot(area_vector(mesh.positions, corners), own_u) > 0;
  }
  return tilt;
}

FeatureWalk::Step FeatureWalk::on_corners() {
  const std::uint32_t a = features_[0].index, b = features_[1].index;
  const DVec3 between = point(1, b) - point(0, a);
  if (const Rise up = rise(0, a, between); up.any) return move(0, FeatureKind::kEdge, up.edge);
  if (const Rise up = rise(1, b, -between); up.any) return move(1, FeatureKind::kEdge, up.edge);
  return Step::kStands;
}

FeatureWalk::Step FeatureWalk::on_edge(int edge_side) {
  const int other = 1 - edge_side;
  const std::uint32_t edge = features_[edge_side].index, corner = features_[other].index;
  const auto [from, to] = sides_[edge_side].mesh.edges[edge].vertex;
  const DVec3 start = point(edge_side, from), along = point(edge_side, to) - start;
  const DVec3 tip = point(other, corner);
  const double place = glm::dot(tip - start, along) / glm::dot(along, along);
  if (!(place > 0)) return move(edge_side, FeatureKind::kVertex, from);
  if (!(place < 1)) return move(edge_side, FeatureKind::kVertex, to);
  const DVec3 between = tip - (start + place * along);
  const Tilt faces = tilt(edge_side, edge, between);
  if (!faces.outward) return Step::kLost;
  if (faces.any) return move(edge_side, FeatureKind::kFace, faces.face);
  if (const Rise up = rise(other, corner, -between); up.any) return move(other, FeatureKind::kEdge, up.edge);
  return Step::kStands;
}

FeatureWalk::Step FeatureWalk::on_face(int face_side) {
  const int other = 1 - face_side;
  const std::uint32_t face = features_[face_side].index, corner = features_[other].index;
  const Triangle triangle = shape(face_side, face);
  const DVec3 area = triangle.area_vector(), tip = point(other, corner);
  int farthest = 0;
  double least = 0.0;
  for (int k = 0; k < 3; ++k)
    if (const double depth = inside(triangle, area, k, tip); depth < least) farthest = k, least = depth;
  if (least < 0)
    return move(face_side, FeatureKind::kEdge, sides_[face_side].mesh.triangle_edges[face][farthest]);
  if (!(glm::dot(tip - triangle.corner[0], area) > 0)) return Step::kLost;
  const Rise up = rise(other, corner, -area);
  return up.any ? slide(face_side, face, up.edge, tip, up.end) : Step::kStands;
}

FeatureWalk::Step FeatureWalk::on_edges() {
  std::array<std::array<std::uint32_t, 2>, 2> ends;
  std::array<DVec3, 2> start, along;
  for (int side = 0; side < 2; ++side) {
    const Edge& edge = sides_[side].mesh.edges[features_[side].index];
    ends[side] = {edge.vertex[0], edge.vertex[1]};
    start[side] = point(side, edge.vertex[0]);
    along[side] = point(side, edge.vertex[1]) - start[side];
  }
  const DVec3 between = start[1] - start[0];
  const LinePair lines(start[0], along[0], start[1], along[1]);
  const SegmentPair edges(lines.s, between, along[0], along[1]);
  const std::array<double, 2> place{edges.s, edges.t};
  Step outcome = Step::kStands;
  for (int side = 0; side < 2; ++side)
    if (place[side] <= 0 || place[side] >= 1)
      outcome = move(side, FeatureKind::kVertex, ends[side][place[side] > 0]);
  if (outcome == Step::kMoved) return outcome;

  const double height = glm::dot(between, lines.normal);
  if (height == 0) return Step::kLost;
  const DVec3 u = height > 0 ? lines.normal : -lines.normal;
  const std::array<Tilt, 2> faces{tilt(0, features_[0].index, u), tilt(1, features_[1].index, -u)};
  if (!faces[0].outward || !faces[1].outward) return Step::kLost;
  for (int side = 0; side < 2; ++side) {
    if (!faces[side].any) continue;
    const int other = 1 - side;
    const DVec3 area = shape(side, faces[side].face).area_vector();
    const std::uint32_t end = ends[other][glm::dot(along[other], area) < 0];
    return slide(side, faces[side].face, features_[other].index, start[other] + place[other] * along[other],
                 end);
  }
  return Step::kStands;
}

// From a point over a face along an edge to its lower end, or to where it leaves the face.
FeatureWalk::Step FeatureWalk::slide(int face_side, std::uint32_t face, std::uint32_t edge, const DVec3& from,
                                     std::uint32_t end) {
  const int other = 1 - face_side;
  const Triangle triangle = shape(face_side, face);
  const DVec3 area = triangle.area_vector(), to = point(other, end);
  const bool begins_on_side = features_[face_side].kind == FeatureKind::kEdge;
  double first = 2.0;
  std::uint32_t left_by = 0;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t side = sides_[face_side].mesh.triangle_edges[face][k];
    if (begins_on_side && side == features_[face_side].index) continue;
    const double ahead = inside(triangle, area, k, to);
    if (ahead >= 0) continue;
    const double here = std::max(inside(triangle, area, k, from), 0.0), place = here / (here - ahead);
    if (place < first) first = place, left_by = side;
  }
  if (first > 1.0) {
    move(face_side, FeatureKind::kFace, face);
    return move(other, FeatureKind::kVertex, end);
  }
  move(face_side, FeatureKind::kEdge, left_by);
  return move(other, FeatureKind::kEdge, edge);
}

}  // namespace palpate
