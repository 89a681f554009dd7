#include "engine/gltf/required_extensions.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace palpate::gltf {
namespace {

constexpr std::string_view kRead[] = {"KHR_mesh_quantization", "KHR_draco_mesh_compression",
                                      "EXT_meshopt_compression", "KHR_meshopt_compression",
                                      "EXT_mesh_gpu_instancing"};

constexpr std::string_view kHarmlessPrefixes[] = {
    "KHR_materials_", "KHR_texture_",           "KHR_lights_",    "KHR_xmp",
    "KHR_animation_", "KHR_techniques_",        "EXT_materials_", "EXT_texture_",
    "EXT_lights_",    "MSFT_texture_",          "MSFT_packing_",  "ADOBE_materials_",
    "KHR_audio",      "EXT_property_animation", "KHR_physics_",   "KHR_implicit_shapes",
    "MPEG_haptic",    "MPEG_material_haptic"};

bool changes_geometry(std::string_view name) {
  if (std::find(std::begin(kRead), std::end(kRead), name) != std::end(kRead)) return false;
  return std::none_of(std::begin(kHarmlessPrefixes), std::end(kHarmlessPrefixes),
                      [&](std::string_view prefix) { return name.starts_with(prefix); });
}

}  // namespace

void check_required_extensions(const Json& root) {
  const auto names = root.find("extensionsRequired");
  if (names == root.end()) return;
  require_array(*names, "extensionsRequired");
  for (const Json& name : *names) {
    if (!name.is_string()) fail(ErrorCode::kBadFormat, "\"extensionsRequired\" must hold strings");
    const auto& text = name.get_ref<const std::string&>();
    if (changes_geometry(text))
      fail(ErrorCode::kUnsupported, "required extension ", quoted(text), " is not supported");
  }
}

}  // namespace palpate::gltf
