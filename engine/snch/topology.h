#pragma once

#include <cstdint>
#include <memory>

#include "engine/mesh/mesh.h"

struct RTCBVHTy;

namespace palpate {

// The bare shape of a binary hierarchy over the triangles of a mesh, which has one at every leaf. Split by
// the surface area heuristic, through Embree's BVH builder.
class Topology {
 public:
  // Throws std::bad_alloc.
  explicit Topology(const Mesh& mesh);

  struct InnerNode;

  // A leaf, or an inner node and all beneath it.
  class Branch {
   public:
    explicit Branch(std::uint32_t triangle) : code_(std::uintptr_t{triangle} << 1 | 1) {}
    explicit Branch(const void* code) : code_(reinterpret_cast<std::uintptr_t>(code)) {}
    void* code() const { return reinterpret_cast<void*>(code_); }

    bool is_leaf() const { return code_ & 1; }
    std::uint32_t triangle() const { return static_cast<std::uint32_t>(code_ >> 1); }
    Branch child(int which) const;
    std::uint32_t leaves() const;

   private:
    const InnerNode& inner() const { return *reinterpret_cast<const InnerNode*>(code_); }

    std::uintptr_t code_;  // an odd one is a leaf's
  };

  Branch root() const { return root_; }

 private:
  struct Release {
    void operator()(RTCBVHTy* bvh) const;
  };

  std::unique_ptr<RTCBVHTy, Release> bvh_;  // owns all inner nodes
  Branch root_;
};

struct Topology::InnerNode {
  void* children[2];
  std::uint32_t leaves;
};

inline Topology::Branch Topology::Branch::child(int which) const {
  return Branch(inner().children[which]);
}

inline std::uint32_t Topology::Branch::leaves() const {
  return is_leaf() ? 1 : inner().leaves;
}

}  // namespace palpate
