#pragma once

#include <tiny_gltf.h>

#include "engine/math/vector.h"

namespace palpate::gltf {

// T · R · S; the quaternion is normalised. Throws kBadFormat if it has no length.
DMat4 compose(const DVec3& translation, const DQuat& rotation, const DVec3& scale);

// A node's own transform, from its matrix or its translation, rotation and scale.
DMat4 parent_from_node(const tinygltf::Node& node);

}  // namespace palpate::gltf
