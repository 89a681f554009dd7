#pragma once

#include <filesystem>
#include <string_view>

namespace palpate::gltf {

// The file that `uri` names in `folder` or below. Throws kUnsafePath for everything that leads, or may lead,
// elsewhere: other schemes, absolute paths, drive letters, backslashes, "..", symbolic links that leave the
// folder. What is named need not exist.
std::filesystem::path resolve_uri(std::string_view uri, const std::filesystem::path& folder);

}  // namespace palpate::gltf
