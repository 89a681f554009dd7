#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "engine/base/result.h"
#include "engine/gltf/gltf_options.h"
#include "engine/gltf/gltf_scene.h"

namespace palpate {

// Reads the geometry of a .gltf or .glb file: never an image, an animation or a texture. External buffers
// come only from the file's own folder or below. Errors: kFileNotFound, kFileRead, kBadFormat, kUnsupported,
// kUnsafePath, kLimit, kNonFinite, kNoTriangles, kInvalidArgument (no such scene), kOutOfMemory.
Result<GltfScene> read_gltf_file(const std::filesystem::path& path, const GltfOptions& options);

// The same from bytes. External buffers come from `folder`; if that is empty there are none. `name` is what
// errors call it.
Result<GltfScene> read_gltf_bytes(std::span<const std::byte> bytes, const std::string& name,
                                  const std::filesystem::path& folder, const GltfOptions& options);

}  // namespace palpate
