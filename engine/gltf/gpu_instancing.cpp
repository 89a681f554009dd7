#include "engine/gltf/gpu_instancing.h"

#include <optional>

#include "engine/gltf/load_error.h"
#include "engine/gltf/node_transform.h"

namespace palpate::gltf {
namespace {

constexpr const char* kTranslation = "TRANSLATION";
constexpr const char* kRotation = "ROTATION";
constexpr const char* kScale = "SCALE";

std::optional<AttributeTable> read(const std::map<std::string, int>& attributes, const char* name,
                                   std::uint32_t width, AccessorReader& accessors) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return std::nullopt;
  return accessors.table(found->second, width);
}

}  // namespace

std::uint64_t count_gpu_instances(const std::map<std::string, int>& attributes,
                                  const AccessorReader& accessors) {
  std::optional<std::uint64_t> count;
  for (const char* name : {kTranslation, kRotation, kScale}) {
    const auto found = attributes.find(name);
    if (found == attributes.end()) continue;
    const std::uint64_t here = accessors.accessor(found->second).count;
    if (count && *count != here)
      fail(ErrorCode::kBadFormat, "instance attributes of ", *count, " and ", here, " elements");
    count = here;
  }
  return count.value_or(1);  // with custom attributes alone the mesh stays where the node is
}

std::vector<DMat4> read_gpu_instances(const std::map<std::string, int>& attributes,
                                      AccessorReader& accessors) {
  const auto translations = read(attributes, kTranslation, 3, accessors);
  const auto rotations = read(attributes, kRotation, 4, accessors);
  const auto scales = read(attributes, kScale, 3, accessors);
  std::vector<DMat4> places;
  const std::uint64_t count = count_gpu_instances(attributes, accessors);
  for (std::size_t i = 0; i < count; ++i) {
    DVec3 translation(0.0);
    DVec3 scale(1.0);
    DQuat rotation(1.0, 0.0, 0.0, 0.0);
    if (translations)
      translation = {translations->row(i)[0], translations->row(i)[1], translations->row(i)[2]};
    if (scales) scale = {scales->row(i)[0], scales->row(i)[1], scales->row(i)[2]};
    if (rotations) {
      const double* xyzw = rotations->row(i);
      rotation = DQuat(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    }
    places.push_back(within("instance", i, [&] { return compose(translation, rotation, scale); }));
  }
  return places;
}

}  // namespace palpate::gltf
