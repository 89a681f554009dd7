#include "engine/gltf/gltf_scene.h"

#include <cstddef>
#include <utility>

namespace palpate {
namespace {

using Meshes = std::vector<TriangleSoup>;
using Instances = std::span<const GltfInstance>;

bool any_double_sided(const Meshes& meshes, Instances instances) {
  for (const GltfInstance& instance : instances) {
    if (!meshes[instance.mesh].double_sided.empty()) return true;
  }
  return false;
}

void reserve(const Meshes& meshes, Instances instances, TriangleSoup& soup) {
  std::size_t positions = 0;
  std::size_t triangles = 0;
  for (const GltfInstance& instance : instances) {
    positions += meshes[instance.mesh].positions.size();
    triangles += meshes[instance.mesh].triangles.size();
  }
  soup.positions.reserve(positions);
  soup.triangles.reserve(triangles);
}

void append(const TriangleSoup& mesh, const DMat4& scene_from_mesh, TriangleSoup& soup) {
  const DMat3 linear(scene_from_mesh);
  const DVec3 translation(scene_from_mesh[3]);
  const auto first = static_cast<std::uint32_t>(soup.positions.size());
  for (const DVec3& position : mesh.positions) soup.positions.push_back(linear * position + translation);
  const bool mirrored = glm::determinant(linear) < 0.0;
  for (TriangleIndices triangle : mesh.triangles) {
    if (mirrored) std::swap(triangle[1], triangle[2]);
    for (std::uint32_t& corner : triangle) corner += first;
    soup.triangles.push_back(triangle);
  }
}

}  // namespace

TriangleSoup bake(const Meshes& meshes, Instances instances) {
  TriangleSoup soup;
  reserve(meshes, instances, soup);
  const bool flags = any_double_sided(meshes, instances);
  for (const GltfInstance& instance : instances) {
    const TriangleSoup& mesh = meshes[instance.mesh];
    append(mesh, instance.scene_from_mesh, soup);
    if (!flags) continue;
    soup.double_sided.insert(soup.double_sided.end(), mesh.double_sided.begin(), mesh.double_sided.end());
    soup.double_sided.resize(soup.triangles.size(), false);
  }
  return soup;
}

TriangleSoup bake(const GltfScene& scene) {
  return bake(scene.meshes, scene.instances);
}

}  // namespace palpate
