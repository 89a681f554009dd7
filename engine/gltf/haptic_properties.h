#pragma once

#include <string>
#include <vector>

#include "engine/gltf/collision_filter.h"
#include "engine/gltf/gltf_json.h"
#include "engine/gltf/haptic_material.h"

namespace palpate::gltf {

struct NodeHaptics {
  HapticMaterial material;    // of its `extras`
  int physics_material = -1;  // into HapticProperties::frictions
  int collision_filter = -1;  // into HapticProperties::filters
  bool moves = false;         // it has a motion
  bool solid = true;          // false: a trigger and no collider
};

// What a document says of how its objects feel and which of them touch. Extensions are checked as strictly as
// geometry; `extras` may mean anything, so that what is no sensible number in them is only noted.
struct HapticProperties {
  std::vector<NodeHaptics> nodes;         // by node
  std::vector<HapticMaterial> meshes;     // by mesh: its `extras`, then MPEG_material_haptic
  std::vector<HapticMaterial> frictions;  // of physics materials
  std::vector<CollisionFilter> filters;
  std::vector<std::string> notes;
};

HapticProperties read_haptics(Json& root);

}  // namespace palpate::gltf
