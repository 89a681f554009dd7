#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/creases.h"
#include "engine/snch/packed_node.h"

namespace palpate {

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

  Node root() const { return node(0); }
  Node node(std::uint32_t index) const { return nodes_[index].unpacked(); }
  const PackedNode& packed(std::uint32_t index) const { return nodes_[index]; }
  OwnedFeatures owned(std::uint32_t triangle) const { return owned_[triangle]; }

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t bytes() const {
    return nodes_.size() * sizeof(PackedNode) + owned_.size() * sizeof(OwnedFeatures);
  }
  double build_us() const { return build_us_; }

 private:
  static Tree build(const Mesh& mesh, const Creases* creases);

  std::vector<PackedNode> nodes_;  // parents before children, a first child right after its parent
  std::vector<OwnedFeatures> owned_;
  double build_us_ = 0.0;
};

}  // namespace palpate
