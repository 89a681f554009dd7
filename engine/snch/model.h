#pragma once

#include <memory>
#include <mutex>

#include "engine/mesh/mesh.h"
#include "engine/snch/near_tree.h"

namespace palpate {

// A mesh and its hierarchy, which is built when it is first asked for. Safe to share between threads.
class Model {
 public:
  explicit Model(Mesh mesh);

  const Mesh& mesh() const { return mesh_; }
  const DVec3& centre() const { return centre_; }  // of a bounding sphere, metres
  double radius() const { return radius_; }
  const Box& bounds() const { return bounds_; }  // metres

  // Builds the hierarchy on the first call; others wait for it. Throws std::bad_alloc.
  const Tree& tree() const;

  // The hierarchy if it is built.
  const Tree* tree_if_built() const;

  // The same for searches that ask for near minima, too.
  const NearTree& near_tree() const;
  const Tree& tree(bool near_minima) const { return near_minima ? near_tree().tree : tree(); }
  const NearTree* near_tree_if_built() const;

 private:
  Mesh mesh_;
  Box bounds_;
  DVec3 centre_{0.0};
  double radius_ = 0.0;
  mutable std::once_flag built_;
  mutable std::once_flag near_built_;
  mutable std::mutex mutex_;  // guards the trees for those who only look
  mutable std::unique_ptr<const Tree> tree_;
  mutable std::unique_ptr<const NearTree> near_tree_;
};

}  // namespace palpate
