#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "engine/math/vector.h"
#include "engine/mesh/mesh.h"

namespace palpate::oracle {

using TriangleIndex = std::uint32_t;

// A place of a surface: 0 a vertex, 1 an edge, 2 a face.
struct Place {
  int dimension;
  std::uint32_t index;
};

// A triangle surface with plain maps for connectivity, built apart from the engine's: only the cleaned
// positions and triangles are shared. Double precision, metres.
class Surface {
 public:
  explicit Surface(const Mesh& mesh);

  std::vector<DVec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<bool> double_sided;
  std::vector<DVec3> normals;
  double diagonal = 0.0;

  std::uint32_t edge(TriangleIndex triangle, int side) const { return sides_[triangle][side]; }

  // The place that the engine names so; edges are found by their ends.
  Place place_of(Feature feature) const;

  // The unit direction of an edge.
  DVec3 direction(Place edge) const;

  // The lowest place that holds a point of the named one: a vertex or an edge if the point is that near to
  // it.
  Place lowest_at(Place place, const DVec3& point, double near) const;

  // The triangles that hold a place.
  std::vector<TriangleIndex> star(Place place) const;

  // The largest u·d over unit directions d of the tangent cone: every triangle of the star contributes its
  // own. For an edge u is at right angles to it; for a face it is how far u leans from its normal.
  double lean(Place place, const DVec3& u) const;

  // u·N over the length of N, the angle-weighted pseudonormal; 1 where the outward test is skipped.
  double outwardness(Place place, const DVec3& u) const;

  // The surface is open or double-sided there.
  bool skips_outward_test(Place place) const;

 private:
  struct EdgeRecord {
    std::vector<TriangleIndex> triangles;
    int balance = 0;  // uses forward minus uses backward
  };
  DVec3 pseudonormal(Place place) const;

  const Mesh& mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edge_between_;
  std::vector<EdgeRecord> edges_;
  std::vector<std::array<std::uint32_t, 2>> edge_ends_;
  std::vector<std::array<std::uint32_t, 3>> sides_;
  std::vector<std::vector<TriangleIndex>> at_vertex_;
  std::vector<bool> open_vertex_;
};

}  // namespace palpate::oracle
