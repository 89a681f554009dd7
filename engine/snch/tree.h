#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/cone.h"
#include "engine/mesh/creases.h"

namespace palpate {

// A node of a spatialized normal cone hierarchy [JC01]: bounds of its triangles and of all directions in
// which a local minimum distance can leave them, that is, the outward polar cones of the faces, edges and
// vertices that its triangles own. All bounds are rounded outward. Normalised frame of the model.
struct alignas(64) Node {
  Vec3 centre;  // of box and sphere
  float radius;
  Vec3 half;          // of the box
  float cone_cosine;  // negative: the cone is whole
  Vec3 cone_axis;
  float cone_sine;
  std::uint8_t sweep_high[3];  // 255 · largest component of the cone's directions along +x, +y, +z
  std::uint8_t sweep_low[3];   // the same along −x, −y, −z
  std::uint16_t reserved;
  std::uint32_t link;  // inner node: its second child, the first one follows it; leaf: kLeaf | triangle

  static constexpr std::uint32_t kLeaf = 1u << 31;
  bool is_leaf() const { return (link & kLeaf) != 0; }
  std::uint32_t triangle() const { return link & ~kLeaf; }
  std::uint32_t second_child() const { return link; }
};
static_assert(sizeof(Node) == 64);

// Which of its corners, sides and faces a triangle brings into the search: those that it owns and that can
// hold an LMD, and those that can hold a near minimum.
struct OwnedFeatures {
  std::uint8_t corners : 3;
  std::uint8_t sides : 3;
  std::uint8_t near_corners : 3;
  std::uint8_t near_sides : 3;
};

// The hierarchy of one mesh. Immutable once built.
class Tree {
 public:
  // Throws std::bad_alloc, also when the builder runs out of memory.
  static Tree build(const Mesh& mesh);

  // For searches that ask for near minima, too.
  static Tree build(const Mesh& mesh, const Creases& creases);

  const Node& root() const { return nodes_.front(); }
  const Node& node(std::uint32_t index) const { return nodes_[index]; }
  OwnedFeatures owned(std::uint32_t triangle) const { return owned_[triangle]; }

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t bytes() const { return nodes_.size() * sizeof(Node) + owned_.size() * sizeof(OwnedFeatures); }
  double build_us() const { return build_us_; }

 private:
  static Tree build(const Mesh& mesh, const Creases* creases);

  std::vector<Node> nodes_;  // parents before children, a first child right after its parent
  std::vector<OwnedFeatures> owned_;
  double build_us_ = 0.0;
};

}  // namespace palpate
