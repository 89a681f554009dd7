#include "engine/descent/near_explorer.h"

#include <algorithm>
#include <iterator>

#include "engine/snch/near_minima.h"

namespace palpate {
namespace {

// At most so many pairs of triangles are tested.
constexpr std::size_t kMostExplored = 2048;

// Open at a time, once memory is fixed.
constexpr std::size_t kMostOpen = 4096;

// A triangle with all its corners and sides that can hold a near minimum, whoever owns them.
TestedTriangle near_triangle(const Model& model, std::uint32_t t, const Triangle& shape) {
  const Mesh& mesh = model.mesh();
  const Tree& tree = model.near_tree().tree;
  TestedTriangle tested{t, shape, 0, 0};
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t vertex = mesh.triangles[t][k], edge = mesh.triangle_edges[t][k];
    const std::uint32_t owner = mesh.owner_of_vertex(vertex), edge_owner = mesh.owner_of_edge(edge);
    const auto corner = std::find(mesh.triangles[owner].begin(), mesh.triangles[owner].end(), vertex) -
                        mesh.triangles[owner].begin();
    const auto& sides = mesh.triangle_edges[edge_owner];
    const auto side = std::find(sides.begin(), sides.end(), edge) - sides.begin();
    if (tree.owned(owner).near_corners >> corner & 1) tested.near_corners |= 1u << k;
    if (tree.owned(edge_owner).near_sides >> side & 1) tested.near_sides |= 1u << k;
  }
  return tested;
}

}  // namespace

void NearExplorer::explore(const Model& a, const Model& b, const Pose& a_from_b, double cutoff,
                           LmdSet& found) {
  const Placement placement(a.mesh().frame, b.mesh().frame, a_from_b);
  const Creases &creases_a = a.near_tree().creases, &creases_b = b.near_tree().creases;
  std::vector<NearMinimum>& near_minima = found.near_minima;
  NearMinimumTest test(NearPolar({a.mesh(), placement, false}, creases_a),
                       NearPolar({b.mesh(), placement, true}, creases_b),
                       {cutoff / a.mesh().frame.scale, touching_distance(placement), 0.0}, near_minima);
  near_minima.clear();
  explored_.clear();
  open_.clear();
  for (const Lmd& lmd : found.lmds) open_around(a.mesh(), b.mesh(), lmd, found);
  for (keep_unexplored(); !open_.empty() && explored_.size() < kMostExplored; keep_unexplored()) {
    const std::size_t before = near_minima.size();
    for (const TrianglePair& pair : open_) {
      if (fixed_ && !has_near_room(near_minima)) {
        found.cut = true;
        break;
      }
      test(near_triangle(a, pair.a, triangle_of(a.mesh(), pair.a)),
           near_triangle(b, pair.b, triangle_of(b.mesh(), pair.b, placement)));
    }
    found.work.triangle_pairs += open_.size();
    mark_explored();
    for (std::size_t i = before; i < near_minima.size(); ++i)
      open_around(a.mesh(), b.mesh(), near_minima[i], found);
  }
  settle_near_minima(creases_a, creases_b, near_minima);
  for (Lmd& near : near_minima) near = in_metres(a.mesh().frame, near);
}

// The lists change places, so each has room for the longest.
void NearExplorer::fix() {
  fixed_ = true;
  for (std::vector<TrianglePair>* list : {&open_, &explored_, &merged_})
    list->reserve(kMostExplored + kMostOpen);
}

void NearExplorer::open_around(const Mesh& a, const Mesh& b, const Lmd& minimum, LmdSet& found) {
  for (std::uint32_t in_a : triangles_at(a, minimum.feature_a))
    for (std::uint32_t in_b : triangles_at(b, minimum.feature_b)) {
      if (fixed_ && open_.size() == kMostOpen) {
        found.cut = true;
        return;
      }
      open_.push_back({in_a, in_b});
    }
}

// In ascending order, each once.
void NearExplorer::keep_unexplored() {
  std::sort(open_.begin(), open_.end());
  open_.erase(std::unique(open_.begin(), open_.end()), open_.end());
  merged_.clear();
  std::set_difference(open_.begin(), open_.end(), explored_.begin(), explored_.end(),
                      std::back_inserter(merged_));
  open_.swap(merged_);
}

void NearExplorer::mark_explored() {
  merged_.clear();
  std::merge(open_.begin(), open_.end(), explored_.begin(), explored_.end(), std::back_inserter(merged_));
  explored_.swap(merged_);
  open_.clear();
}

}  // namespace palpate
