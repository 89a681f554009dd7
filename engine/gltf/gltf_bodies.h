#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/gltf/gltf_scene.h"
#include "engine/math/pose.h"
#include "engine/mesh/mesh.h"

namespace palpate {

// A part of a scene that moves as one: a node and its mesh or, for the tool, a node and all that is below.
struct GltfBody {
  std::string name;
  std::uint32_t node = 0;        // index in the file
  std::uint32_t shape = 0;       // into GltfBodies::shapes
  std::int32_t above = -1;       // into GltfBodies::bodies: the nearest in the hierarchy; −1: none
  Pose scene_from_body;          // the rigid part of the node's place
  DMat4 body_from_node{1.0};     // the rest, which the shape holds: scale, mirror, shear
  DMat4 above_from_parent{1.0};  // the node's parent, in the frame of the body above or else of the scene
  HapticMaterial material;
  bool tool = false;
  bool moves = false;
  bool touches_tool = true;
};

struct GltfBodies {
  std::vector<Mesh> shapes;        // frame of the body; bodies share one if they have the same mesh and scale
  std::vector<GltfBody> bodies;    // parents before children
  std::vector<std::string> notes;  // what was left out, a sentence each
};

// The bodies of a scene that was read with its hierarchy, all of it `scale` times as large. `tool` names the
// tool's node or, as "/nodes/5", tells its index; if it is empty, there is none. Errors: kInvalidArgument (no
// such node, or several), kNoTriangles, and those of build_mesh.
Result<GltfBodies> gather_bodies(const GltfScene& scene, const std::string& tool, const MeshOptions& options,
                                 double scale = 1.0);

}  // namespace palpate
