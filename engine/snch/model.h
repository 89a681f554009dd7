#pragma once

#include <mutex>

#include "engine/mesh/mesh.h"
#include "engine/snch/tree.h"

namespace palpate {

// A mesh and its hierarchy, which is built when it is first asked for. Safe to share between threads.
class Model {
 public:
  explicit Model(Mesh mesh) : mesh_(std::move(mesh)) {}

  const Mesh& mesh() const { return mesh_; }
  const Tree& tree() const;         // builds it if need be
  bool has_tree() const;

  const DVec3& centre() const { return centre_; }    // of the bounding sphere, metres
  double radius() const { return radius_; }

 private:
  Mesh mesh_;
};

}  // namespace palpate
