#include "engine/snch/tree.h"

#include <algorithm>
#include <cmath>

#include "engine/base/clock.h"
#include "engine/base/parallel.h"
#include "engine/math/box.h"
#include "engine/snch/near_polar.h"
#include "engine/snch/polar_directions.h"
#include "engine/snch/topology.h"

namespace palpate {
namespace {

// Covers the rounding of a cone to float32 and of its tests, and the widest parallel tolerance of a search.
constexpr double kConeMargin = 4e-5;

// The smoothing angle; cones of near minima are wider by it.
constexpr double kSmoothingAngle = 1.0001 * Smoothing::kTangent;

// Relative growth of float32 bounds that covers their rounding.
constexpr double kOutward = 1.0 + 1e-6;

// Above this many triangles a sphere is that of the box: visiting all corners at every level would cost n log
// n.
constexpr std::uint32_t kExactLeaves = 512;

// What one thread fills at a time.
constexpr std::uint32_t kSubtreeLeaves = 1u << 13;

std::vector<std::uint32_t> leaf_triangles(const std::vector<TopologyNode>& topology) {
  std::vector<std::uint32_t> order;
  order.reserve(topology.size() / 2 + 1);
  for (const TopologyNode& node : topology)
    if (node.link & Node::kLeaf) order.push_back(node.link & ~Node::kLeaf);
  return order;
}

class NodeFiller {
 public:
  NodeFiller(const Mesh& mesh, const Creases* creases, const std::vector<TopologyNode>& topology,
             std::vector<PackedNode>& nodes)
      : mesh_(mesh),
        topology_(topology),
        order_(leaf_triangles(topology)),
        directions_(mesh, order_, creases),
        cone_margin_(std::tan(0.5 * (creases ? kConeMargin + kSmoothingAngle : kConeMargin))),
        nodes_(nodes) {}

  // Small subtrees side by side, then what is above them.
  void fill() {
    nodes_.resize(topology_.size());
    std::vector<Place> small, above;
    std::uint32_t rank = 0;
    for (std::uint32_t i = 0; i < topology_.size();) {
      const bool is_small = leaves_of(i) <= kSubtreeLeaves;
      (is_small ? small : above).push_back({i, rank});
      if (is_small) rank += leaves_of(i);
      i = is_small ? topology_[i].end : i + 1;
    }
    in_parallel(small.size(), [&](std::size_t subtree) { fill_subtree(small[subtree]); });
    for (auto place = above.rbegin(); place != above.rend(); ++place) fill_node(*place);
  }

 private:
  struct Place {
    std::uint32_t node;
    std::uint32_t rank;  // of its first leaf
  };

  std::uint32_t leaves_of(std::uint32_t i) const { return (topology_[i].end - i + 1) / 2; }

  void fill_subtree(const Place& root) {
    std::uint32_t rank = root.rank + leaves_of(root.node);
    for (std::uint32_t i = topology_[root.node].end; i-- > root.node;) {
      if (topology_[i].link & Node::kLeaf) --rank;
      fill_node({i, rank});
    }
  }

  void fill_node(const Place& place) {
    const auto [i, rank] = place;
    nodes_[i].link = topology_[i].link;
    fill_bounds(i, rank, rank + leaves_of(i));
    fill_cone(i, rank, rank + leaves_of(i));
  }

  // `first` of an inner node is the rank of its first leaf: it is visited right after that leaf.
  void fill_bounds(std::uint32_t i, std::uint32_t first, std::uint32_t end) {
    PackedNode& node = nodes_[i];
    const Box box = node.is_leaf() ? box_of(first) : united(nodes_[i + 1], nodes_[node.link]);
    node.centre = Vec3(box.centre());
    const DVec3 centre(node.centre);
    const DVec3 half = glm::max(box.high - centre, centre - box.low);
    const double radius = end - first > kExactLeaves ? glm::length(half) : reach(centre, first, end);
    node.set_box(kOutward * half, kOutward * radius);
  }

  Box box_of(std::uint32_t rank) const {
    Box box;
    for (std::uint32_t vertex : mesh_.triangles[order_[rank]]) box.grow(mesh_.position(vertex));
    return box;
  }

  static Box united(const PackedNode& one, const PackedNode& other) {
    Box box;
    for (const PackedNode* node : {&one, &other}) {
      box.grow(DVec3(node->centre) - DVec3(node->half_size()));
      box.grow(DVec3(node->centre) + DVec3(node->half_size()));
    }
    return box;
  }

  // The distance of the farthest corner from `centre`.
  double reach(const DVec3& centre, std::uint32_t first, std::uint32_t end) const {
    double squared = 0.0;
    for (std::uint32_t rank = first; rank < end; ++rank)
      for (std::uint32_t vertex : mesh_.triangles[order_[rank]]) {
        const DVec3 arm = mesh_.position(vertex) - centre;
        squared = std::max(squared, glm::dot(arm, arm));
      }
    return std::sqrt(squared);
  }

  void fill_cone(std::uint32_t i, std::uint32_t first, std::uint32_t end) {
    const Cone cone = unbounded(i, first) ? Cone::whole() : cone_around(directions_.of(first, end));
    nodes_[i].set_cone(cone.widened(cone_margin_));
  }

  bool unbounded(std::uint32_t i, std::uint32_t first) const {
    if (nodes_[i].is_leaf()) return directions_.unbounded[first] != 0;
    return nodes_[i + 1].cone_is_whole() || nodes_[nodes_[i].link].cone_is_whole();
  }

  const Mesh& mesh_;
  const std::vector<TopologyNode>& topology_;
  const std::vector<std::uint32_t> order_;
  const PolarDirections directions_;
  const double cone_margin_;  // the tangent of its half
  std::vector<PackedNode>& nodes_;
};

std::vector<OwnedFeatures> owned_features(const Mesh& mesh) {
  std::vector<OwnedFeatures> owned(mesh.triangles.size());
  for (std::uint32_t t = 0; t < owned.size(); ++t) {
    unsigned corners = 0, sides = 0;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[t][k], edge = mesh.triangle_edges[t][k];
      if (mesh.owner_of_vertex(vertex) == t && mesh.vertex_flags[vertex].active) corners |= 1u << k;
      if (mesh.owner_of_edge(edge) == t && mesh.edge_flags[edge].active) sides |= 1u << k;
    }
    owned[t] = {static_cast<std::uint8_t>(corners & 7u), static_cast<std::uint8_t>(sides & 7u), 0, 0};
  }
  return owned;
}

void add_near_features(const Mesh& mesh, const Creases& creases, std::vector<OwnedFeatures>& owned) {
  for (std::uint32_t t = 0; t < owned.size(); ++t) {
    unsigned corners = 0, sides = 0;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[t][k], edge = mesh.triangle_edges[t][k];
      if (mesh.owner_of_vertex(vertex) == t && near_corner(mesh, creases, vertex)) corners |= 1u << k;
      if (mesh.owner_of_edge(edge) == t && near_side(mesh, creases, edge)) sides |= 1u << k;
    }
    owned[t].near_corners = static_cast<std::uint8_t>(corners & 7u);
    owned[t].near_sides = static_cast<std::uint8_t>(sides & 7u);
  }
}

}  // namespace

Tree Tree::build(const Mesh& mesh) {
  return build(mesh, nullptr);
}

Tree Tree::build(const Mesh& mesh, const Creases& creases) {
  return build(mesh, &creases);
}

Tree Tree::build(const Mesh& mesh, const Creases* creases) {
  const Stopwatch watch;
  Tree tree;
  const std::vector<TopologyNode> topology = build_topology(mesh);
  NodeFiller(mesh, creases, topology, tree.nodes_).fill();
  tree.owned_ = owned_features(mesh);
  if (creases) add_near_features(mesh, *creases, tree.owned_);
  tree.build_us_ = watch.elapsed_us();
  return tree;
}

}  // namespace palpate
