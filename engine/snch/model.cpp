#include "engine/snch/model.h"

#include <cmath>

namespace palpate {

Model::Model(Mesh mesh) : mesh_(std::move(mesh)) {
  Box box;
  for (const Vec3& position : mesh_.positions) box.grow(DVec3(position));
  double squared = 0.0;
  for (const Vec3& position : mesh_.positions) {
    const DVec3 arm = DVec3(position) - box.centre();
    squared = std::max(squared, glm::dot(arm, arm));
  }
  bounds_ = {mesh_.frame.metres(box.low), mesh_.frame.metres(box.high)};
  centre_ = mesh_.frame.metres(box.centre());
  radius_ = mesh_.frame.scale * std::sqrt(squared) * (1 + 1e-12);
}

const Tree& Model::tree() const {
  std::call_once(built_, [this] {
    auto tree = std::make_unique<const Tree>(Tree::build(mesh_));
    const std::lock_guard lock(mutex_);
    tree_ = std::move(tree);
  });
  return *tree_;
}

const Tree* Model::tree_if_built() const {
  const std::lock_guard lock(mutex_);
  return tree_.get();
}

const NearTree& Model::near_tree() const {
  std::call_once(near_built_, [this] {
    auto tree = std::make_unique<const NearTree>(mesh_);
    const std::lock_guard lock(mutex_);
    near_tree_ = std::move(tree);
  });
  return *near_tree_;
}

const NearTree* Model::near_tree_if_built() const {
  const std::lock_guard lock(mutex_);
  return near_tree_.get();
}

}  // namespace palpate
