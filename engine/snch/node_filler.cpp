#include "engine/snch/node_filler.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/snch/farthest_point.h"
#include "engine/snch/near_polar.h"

namespace palpate {
namespace {

// Covers the rounding of a cone to float32 and of its tests, and the widest parallel tolerance of a search.
constexpr double kConeMargin = 4e-5;

// The smoothing angle; cones of near minima are wider by it.
constexpr double kSmoothingAngle = 1.0001 * Smoothing::kTangent;

// Relative growth of bounds that covers the rounding of float32 distances.
constexpr double kOutward = 1.0 + 1e-6;

// Above this many triangles a sphere is that of the box: visiting all corners at every level would cost n log
// n.
constexpr std::uint32_t kExactLeaves = 512;

// What one thread fills at a time, with cones around all directions; above it they are around other cones.
constexpr std::uint32_t kSubtreeLeaves = 1u << 13;

// The second child comes right after all of the first.
std::uint32_t second_child(Topology::Branch branch, std::uint32_t index) {
  return index + 2 * branch.child(0).leaves();
}

Box united(const Box& one, const Box& other) {
  return {glm::min(one.low, other.low), glm::max(one.high, other.high)};
}

// Centre and half size; the latter is returned.
DVec3 place_box(const Box& box, PackedNode& node) {
  node.centre = Vec3(box.centre());
  const DVec3 centre(node.centre);
  return kOutward * glm::max(box.high - centre, centre - box.low);
}

}  // namespace

class NodeFiller::SubtreeFiller {
 public:
  explicit SubtreeFiller(const NodeFiller& all) : all_(all) {}

  Bounds fill(const Subtree& subtree) {
    const Contents contents = fill(subtree.branch, subtree.index);
    return {contents.box, contents.cone};
  }

 private:
  struct Contents {
    Box box;
    Cone cone;
    DVec3 direction_sum{0.0};
  };

  Contents fill(Branch branch, std::uint32_t index) {
    const std::size_t corner = corners_.size(), direction = directions_.size();
    Contents contents = branch.is_leaf() ? add_leaf(branch.triangle()) : add_children(branch, index);
    PackedNode& node = all_.nodes_[index];
    node.link = branch.is_leaf() ? Node::kLeaf | branch.triangle() : second_child(branch, index);
    const DVec3 half = place_box(contents.box, node);
    node.set_box(half, branch.leaves() > kExactLeaves ? glm::length(half) : reach(node.centre, corner));
    if (!contents.cone.is_whole())
      contents.cone = cone_around(directions_, direction, directions_.size(), contents.direction_sum);
    node.set_cone(contents.cone.widened(all_.cone_margin_));
    return contents;
  }

  // Their cones say no more here than whether they are whole.
  Contents add_leaf(std::uint32_t triangle) {
    Contents contents;
    for (std::uint32_t vertex : all_.mesh_.triangles[triangle]) {
      contents.box.grow(all_.mesh_.position(vertex));
      corners_.push_back(all_.mesh_.positions[vertex]);
    }
    const std::size_t first = directions_.size();
    if (all_.directions_.add(triangle, directions_)) contents.cone.half_tangent = 0.0;
    for (std::size_t i = first; i < directions_.size(); ++i) contents.direction_sum += DVec3(directions_[i]);
    return contents;
  }

  Contents add_children(Branch branch, std::uint32_t index) {
    const Contents one = fill(branch.child(0), index + 1);
    const Contents other = fill(branch.child(1), second_child(branch, index));
    return {united(one.box, other.box), one.cone.is_whole() ? one.cone : other.cone,
            one.direction_sum + other.direction_sum};
  }

  // The distance of the farthest corner, from the `first` on.
  double reach(const Vec3& centre, std::size_t first) const {
    if (corners_.size() - first == 3) return reach_of_one(centre, first);
    const FarthestPoint farthest = farthest_point(corners_, first, corners_.size(), centre);
    return kOutward * std::sqrt(double{farthest.squared});
  }

  // The same of one triangle, of which there are many.
  double reach_of_one(const Vec3& centre, std::size_t first) const {
    double squared = 0.0;
    for (std::size_t i = first; i < first + 3; ++i) {
      const DVec3 arm = DVec3(corners_[i]) - DVec3(centre);
      squared = std::max(squared, glm::dot(arm, arm));
    }
    return kOutward * std::sqrt(squared);
  }

  const NodeFiller& all_;
  PointList corners_;
  PointList directions_;
};

NodeFiller::NodeFiller(const Mesh& mesh, const Creases* creases, std::vector<PackedNode>& nodes)
    : mesh_(mesh),
      directions_(mesh, creases),
      cone_margin_(std::tan(0.5 * (creases ? kConeMargin + kSmoothingAngle : kConeMargin))),
      nodes_(nodes) {}

void NodeFiller::fill(const Topology& topology) {
  nodes_.resize(2 * std::size_t{topology.root().leaves()} - 1);
  std::vector<Subtree> subtrees;
  collect(topology.root(), 0, subtrees);
  in_parallel(subtrees.size(),
              [&](std::size_t i) { subtrees[i].bounds = SubtreeFiller(*this).fill(subtrees[i]); });
  const Subtree* next = subtrees.data();
  fill_above(topology.root(), 0, next);
}

void NodeFiller::collect(Branch branch, std::uint32_t index, std::vector<Subtree>& subtrees) {
  if (branch.leaves() <= kSubtreeLeaves) {
    subtrees.push_back({branch, index, {}});
    return;
  }
  collect(branch.child(0), index + 1, subtrees);
  collect(branch.child(1), second_child(branch, index), subtrees);
}

// Subtrees come in the order in which they were collected.
NodeFiller::Bounds NodeFiller::fill_above(Branch branch, std::uint32_t index, const Subtree*& next) {
  if (branch.leaves() <= kSubtreeLeaves) return (next++)->bounds;
  const Bounds one = fill_above(branch.child(0), index + 1, next);
  const Bounds other = fill_above(branch.child(1), second_child(branch, index), next);
  const Bounds both{united(one.box, other.box), cone_around(one.cone, other.cone)};
  PackedNode& node = nodes_[index];
  node.link = second_child(branch, index);
  const DVec3 half = place_box(both.box, node);
  node.set_box(half, glm::length(half));
  node.set_cone(both.cone.widened(cone_margin_));
  return both;
}

}  // namespace palpate
