#pragma once

#include "engine/gltf/gltf_json.h"

namespace palpate::gltf {

// Throws kUnsupported, naming it, if `root` requires an extension that may change the geometry and is not
// read here. Extensions of materials, textures, lights, animation and metadata do not change it.
void check_required_extensions(const Json& root);

}  // namespace palpate::gltf
