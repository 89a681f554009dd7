#include "engine/gltf/gltf_scene.h"

#include <cstddef>
#include <utility>

namespace palpate {
namespace {

bool any_double_sided(const GltfScene& scene) {
  for (const GltfInstance& instance : scene.instances) {
    if (!scene.meshes[instance.mesh].double_sided.empty()) return true;
  }
  return false;
}

void reserve(const GltfScene& scene, TriangleSoup& soup) {
  std::size_t positions = 0;
  std::size_t triangles = 0;
  for (const GltfInstance& instance : scene.instances) {
    positions += scene.meshes[instance.mesh].positions.size();
    triangles += scene.meshes[instance.mesh].triangles.size();
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

TriangleSoup bake(const GltfScene& scene) {
  TriangleSoup soup;
  reserve(scene, soup);
  const bool flags = any_double_sided(scene);
  for (const GltfInstance& instance : scene.instances) {
    const TriangleSoup& mesh = scene.meshes[instance.mesh];
    append(mesh, instance.scene_from_mesh, soup);
    if (!flags) continue;
    soup.double_sided.insert(soup.double_sided.end(), mesh.double_sided.begin(), mesh.double_sided.end());
    soup.double_sided.resize(soup.triangles.size(), false);
  }
  return soup;
}

}  // namespace palpate
